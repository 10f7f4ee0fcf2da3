#pragma once
// The complete verification of a plan file.

#include <optional>

#include "tramline/check/verify.h"
#include "tramline/io/plan/read_plan.h"

namespace tramline::app {

/// The verdict on the plan, on the data that its file repeats and, where the field it was made for is given,
/// on whether that is the same. Where shapes or pieces are unsound the other checks are omitted, as they
/// would only repeat it.
check::Verdict judge(const io::PlanFile& file, const std::optional<Field>& input);

}  // namespace tramline::app
