#pragma once
// The gaps of a drive, as fields to plan repairs on.

#include <string>
#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/coverage.h"
#include "tramline/model/field.h"

namespace tramline::app {

/// One connected part of the evaluated field, with its obstacles and its missed land.
struct GapField {
  Field field;
  std::vector<Gap> gaps;
  Region missed;
  std::vector<DrivenLine> driven;  ///< the whole path of the machine
};

/// The parts of an evaluation, one for each polygon of its field, in their order; Field::source names the
/// polygon. `file`: file of the evaluation, for messages. Throws kBadInput where there was no field, and
/// where nothing was missed. O(parts · gaps).
std::vector<GapField> gap_fields(const Coverage& coverage, const std::string& file);

}  // namespace tramline::app
