#include "many_fields.h"

#include <fmt/format.h>

#include "report/report_parts.h"
#include "tramline/geometry/error.h"

namespace tramline::app {

int work_on_many_fields(const FieldInput& input, const ManyFieldsReport& report,
                        const std::function<void(const Field&)>& work) {
  std::size_t refused = 0, done = 0;
  const auto refuse = [&](const std::string& field_id, const std::string& sentence) {
    ++refused;
    if (report.json)
      fmt::print("{}\n", json_line(refusal_json(field_id, sentence)));
    else
      fmt::print(stderr, "{} refused: {}\n", field_id, sentence);
  };
  for (const Refusal& refusal : input.refusals) refuse(refusal.field_id, refusal.sentence);
  for (const Field& field : input.fields) {
    try {
      work(field);
      ++done;
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kBadInput) throw;
      refuse(field.id, error.what());
    }
  }
  if (report.json && !input.skipped.empty())
    fmt::print("{}\n", json_line({{"skipped", skipped_json(input.skipped)}}));
  if (!report.json && !report.quiet) fmt::print(stderr, "{}", skipped_rows(input.skipped));
  if (!report.quiet)
    fmt::print(stderr, "{} {} of {} fields, {} refused\n", report.done, done,
               input.fields.size() + input.refusals.size(), refused);
  return done > 0 ? 0 : 2;
}

}  // namespace tramline::app
