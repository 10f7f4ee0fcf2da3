#pragma once
// Divides a quad into slabs along the way, each so narrow that its density can be taken as linear across it.

#include <vector>

#include "tramline/coverage/dose/pattern.h"
#include "tramline/coverage/drive/worked_step.h"

namespace tramline::coverage {

/// A strip of a quad, with corners in the order of a quad.
struct Slab {
  Quad corners;
  double amount = 0;
  /// Relative density at either side.
  double dense_right = 1;
  double dense_left = 1;
};

/// Appends the slabs of a quad that works the section `section` with `per_m` for each metre across where the
/// pattern is 1; their amounts add up to per_m · ∫pattern. Where the pattern is wider than the machine, a
/// section that ends `half_width_m` or more from its middle also applies the part that lands beyond it. Slabs
/// end where the pattern bends and where the inside of a turn begins to go backwards; in turns they are so
/// narrow that the ways of their two sides differ by a fifth at most, but not narrower than half a cell.
/// O(slabs). Precondition: section.left_m > section.right_m.
void append_slabs(const Quad& quad, const Section& section, double per_m, const TransversePattern& pattern,
                  double half_width_m, double cell_m, std::vector<Slab>& out);

}  // namespace tramline::coverage
