#pragma once
// Everything there is to say about a plan file.

#include <optional>

#include "tramline/check/verify.h"
#include "tramline/io/plan/read_plan.h"

namespace tramline::app {

/// The verdict on the plan, on what its file repeats, and, where the field it was made for is given, on
/// whether that is the same. Where shapes or pieces are unsound the rest would only repeat it.
check::Verdict judge(const io::PlanFile& file, const std::optional<Field>& input);

}  // namespace tramline::app
