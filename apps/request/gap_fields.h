#pragma once
// What a drive has missed, as fields to plan on.

#include <string>
#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/coverage.h"
#include "tramline/model/field.h"

namespace tramline::app {

/// One connected part of the field that was evaluated, with its obstacles, and what was missed there.
struct GapField {
  Field field;
  std::vector<Gap> gaps;
  Region missed;
  std::vector<DrivenLine> driven;  ///< the whole way of the machine
};

/// Those of an evaluation, one for each polygon of its field, in their order; Field::source says which.
/// `file`: where the evaluation is from, for messages. Throws kBadInput where there was no field, and where
/// nothing was missed. O(parts · gaps).
std::vector<GapField> gap_fields(const Coverage& coverage, const std::string& file);

}  // namespace tramline::app
