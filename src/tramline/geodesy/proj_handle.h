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

/// A context of its own: silent, and never on the network (the same input gives the same plan).
Context make_context();

/// What PROJ last complained about in this context.
std::string last_error(PJ_CONTEXT* context);

}  // namespace tramline::proj
