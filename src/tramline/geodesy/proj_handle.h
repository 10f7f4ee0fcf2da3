#pragma once
// Owning handles for PROJ objects. Included by the .cpp files of geodesy only.

#include <proj.h>

#include <memory>
#include <string>

namespace tramline::proj {

struct DestroyContext {
  void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
};
struct DestroyObject {
  void operator()(PJ* object) const { proj_destroy(object); }
};
using Context = std::unique_ptr<PJ_CONTEXT, DestroyContext>;
using Object = std::unique_ptr<PJ, DestroyObject>;

/// A new context that prints nothing and never uses the network (the same input gives the same plan).
Context make_context();

/// The last error of PROJ in this context.
std::string last_error(PJ_CONTEXT* context);

}  // namespace tramline::proj
