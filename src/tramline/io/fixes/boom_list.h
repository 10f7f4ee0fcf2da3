#pragma once
// The distinct booms of a log.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "tramline/model/work_log.h"

namespace tramline::io {

/// Assigns the numbers stored in Fix::boom.
class BoomList {
 public:
  /// The number of this boom, a new one for a new boom. O(sections · log of booms).
  int number_of(const Boom& boom);
  const std::vector<Boom>& booms() const { return booms_; }

 private:
  std::vector<Boom> booms_;
  std::map<std::vector<double>, int> numbers_;
};

/// Sections side by side from left to right, centred on the machine. A section without width keeps its
/// position in the order and works nothing. Precondition: widths finite and not negative, metres.
Boom side_by_side(std::span<const double> widths_m);

/// One section centred on the machine; none without a width.
Boom one_section(double width_m);

/// A note on implausibly wide booms: lists of widths may give that of the whole machine for each section.
/// Empty where there are none.
std::string note_on_wide(std::span<const Boom> booms);

}  // namespace tramline::io
