#include "commands/many_fields.h"

#include <fmt/format.h>

#include "output/result_output.h"
#include "report/report_parts.h"
#include "request/field_key.h"
#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

class Run {
 public:
  Run(const FieldInput& input, const ManyFieldsReport& report, const ManyFieldsRecord& record)
      : input_(input), report_(report), record_(record) {}

  void refuse(const Refusal& refusal) {
    show({refusal_json(input_.file, input_.layer, refusal),
          fmt::format("{} refused: {}\n", refusal.field_id, refusal.sentence),
          {},
          true});
  }

  void work_on(const Field& field, const std::function<FieldResult(const Field&)>& work) {
    if (record_.record == nullptr) return show(result_of(field, work));
    const std::string key = field_key(field), made_from = record_.made_from(field);
    if (const FieldResult* former = record_.record->finished(key, made_from)) {
      ++former_;
      return show(*former);
    }
    const FieldResult result = result_of(field, work);
    record_.record->add(key, made_from, result);
    show(result);
  }

  int finish() const {
    if (report_.json && !input_.skipped.empty()) print_json_line({{"skipped", skipped_json(input_.skipped)}});
    if (!report_.json && !report_.quiet) fmt::print(stderr, "{}", skipped_rows(input_.skipped));
    if (!report_.quiet)
      fmt::print(stderr, "{} {} of {} fields, {} refused{}\n", report_.done, done_,
                 input_.fields.size() + input_.refusals.size(), refused_,
                 former_ == 0 ? "" : fmt::format("; {} of them by a former run", former_));
    if (refused_ == 0) return 0;
    return done_ > 0 ? 3 : 2;
  }

 private:
  static FieldResult result_of(const Field& field, const std::function<FieldResult(const Field&)>& work) {
    try {
      FieldResult out = work(field);
      out.json = with_field_names(field, out.json);
      return out;
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kBadInput) throw;
      return {with_field_names(field, {{"error", error.what()}}),
              fmt::format("{} refused: {}\n", field.id, error.what()),
              {},
              true};
    }
  }

  void show(const FieldResult& result) {
    ++(result.refused ? refused_ : done_);
    if (report_.json)
      print_json_line(result.json);
    else if (result.refused)
      fmt::print(stderr, "{}", result.text);
    else if (!report_.quiet)
      print_result(result.text);
  }

  const FieldInput& input_;
  const ManyFieldsReport& report_;
  const ManyFieldsRecord& record_;
  std::size_t refused_ = 0, done_ = 0, former_ = 0;
};

}  // namespace

int show_single(const Field& field, const FieldResult& result, const ManyFieldsReport& report) {
  if (report.json)
    print_json_line(with_field_names(field, result.json));
  else if (!report.quiet)
    print_result(result.text);
  return 0;
}

int work_on_many_fields(const FieldInput& input, const ManyFieldsReport& report,
                        const std::function<FieldResult(const Field&)>& work,
                        const ManyFieldsRecord& record) {
  Run run(input, report, record);
  for (const Refusal& refusal : input.refusals) run.refuse(refusal);
  for (const Field& field : input.fields) run.work_on(field, work);
  return run.finish();
}

}  // namespace tramline::app
