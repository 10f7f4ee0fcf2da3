#include "tramline/geodesy/proj_handle.h"

namespace tramline::proj {

Context make_context() {
  Context context(proj_context_create());
  proj_context_set_enable_network(context.get(), 0);
  proj_log_level(context.get(), PJ_LOG_NONE);
  proj_log_func(context.get(), nullptr, [](void*, int, const char*) {});
  return context;
}

std::string last_error(PJ_CONTEXT* context) {
  const int code = proj_context_errno(context);
  if (code == 0) return "unknown reason";
  const char* text = proj_context_errno_string(context, code);
  return text != nullptr ? text : "unknown reason";
}

}  // namespace tramline::proj
