#pragma once
// One verb's work on every field that was read.

#include <functional>

#include "field_options.h"

namespace tramline::app {

struct ManyFieldsReport {
  bool json = false;
  bool quiet = false;
  const char* done = "planned";  ///< what is said of a field when all went well
};

/// Calls `work` for each field. What was refused, on reading or by an Error(kBadInput) of `work`, is listed
/// with its reason, and the rest goes on; last come what was skipped and the counts. Returns the exit code:
/// 2 where every field was refused. Other errors are thrown on.
int work_on_many_fields(const FieldInput& input, const ManyFieldsReport& report,
                        const std::function<void(const Field&)>& work);

}  // namespace tramline::app
