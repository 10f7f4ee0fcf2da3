#pragma once
// The booms of a log, each different one once.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "tramline/model/work_log.h"

namespace tramline::io {

/// Hands out the numbers that Fix::boom holds.
class BoomList {
 public:
  /// The number of this boom; a new one for a boom that was not there yet. O(sections · log of booms).
  int number_of(const Boom& boom);
  const std::vector<Boom>& booms() const { return booms_; }

 private:
  std::vector<Boom> booms_;
  std::map<std::vector<double>, int> numbers_;
};

/// Sections side by side from left to right, in the middle of the machine. A section without width keeps its
/// place among the others and works nothing. Precondition: widths finite and not negative, metres.
Boom side_by_side(std::span<const double> widths_m);

/// One section in the middle of the machine; none for no width.
Boom one_section(double width_m);

/// Tells of booms that are wider than machines are: lists of widths may give that of the whole machine for
/// each section. Empty where there are none.
std::string note_on_wide(std::span<const Boom> booms);

}  // namespace tramline::io
