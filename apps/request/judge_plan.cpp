#include "request/judge_plan.h"

#include <string>
#include <utility>

#include "tramline/check/file/compare_fields.h"
#include "tramline/check/file/compare_layers.h"
#include "tramline/check/file/compare_warnings.h"
#include "tramline/check/file/compare_whole_cost.h"
#include "tramline/check/not_verified.h"
#include "tramline/check/verify.h"

namespace tramline::app {
namespace {

void append(std::vector<check::Violation>& to, const std::vector<check::Violation>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

check::Verdict judge(const io::PlanFile& file, const std::optional<Field>& input) {
  check::Verdict verdict = check::verify(file.plan);
  if (!verdict.complete) return verdict;
  append(verdict.violations,
         check::compare_swaths(file.plan, file.track_order, file.swaths, file.swath_order));
  append(verdict.violations, check::compare_lines(file.plan, file.track_lines));
  for (const io::DerivedNumber& number : file.derived)
    check::compare_number(number.where, number.stored, number.from_shape, number.rounding, number.at,
                          verdict.violations);
  for (const io::DerivedText& text : file.derived_texts)
    check::compare_text(text.where, text.stored, text.from_shape, text.at, verdict.violations);
  append(verdict.violations, check::compare_warnings(file.plan));
  if (file.stated_cost) {
    append(verdict.violations, check::compare_whole_cost(file.plan, *file.stated_cost));
    verdict.not_verified = check::without_rates(std::move(verdict.not_verified));
    for (std::string& name : check::rates_without_effect(file.plan, *file.stated_cost))
      verdict.not_verified.push_back(std::move(name));
  }
  if (!input) return verdict;
  append(verdict.violations, check::compare_fields(file.plan.field, *input));
  verdict.not_verified = check::without_field(std::move(verdict.not_verified));
  return verdict;
}

}  // namespace tramline::app
