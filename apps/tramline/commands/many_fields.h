#pragma once
// One command's work on every field that was read.

#include <functional>
#include <string>

#include "output/run_record.h"
#include "request/field_input.h"

namespace tramline::app {

struct ManyFieldsReport {
  bool json = false;
  bool quiet = false;
  const char* done = "planned";  ///< what is said of a field when all went well
};

/// What a run remembers and finds again.
struct ManyFieldsRecord {
  RunRecord* record = nullptr;                              ///< nullptr: nothing
  std::function<std::string(const Field&)> made_from = {};  ///< differs where the field's result may
};

/// Prints the result for the only field of a run, JSON with its names. Returns the exit code, 0.
int show_single(const Field& field, const FieldResult& result, const ManyFieldsReport& report);

/// Calls `work` for each field and prints what it gives, whole, as soon as it is there: JSON with the names
/// of the field (field_names_json()) first, or the text. What was refused, on reading or by an
/// Error(kBadInput) of `work`, is listed with its reason, and the rest goes on; last come what was skipped
/// and the counts. A field that the record has is not worked on again: its result is printed once more, so
/// that the output is always that of the whole run. Returns the exit code: 3 where some fields were refused
/// and 2 where all were. Other errors are thrown on.
int work_on_many_fields(const FieldInput& input, const ManyFieldsReport& report,
                        const std::function<FieldResult(const Field&)>& work,
                        const ManyFieldsRecord& record = {});

}  // namespace tramline::app
