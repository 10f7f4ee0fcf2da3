// Any text as the transverse pattern of a machine, and what is made of its rows.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "tramline/coverage/dose/pattern.h"
#include "tramline/geometry/error.h"
#include "tramline/io/pattern/pattern_rows.h"

namespace {

using tramline::coverage::PatternStretch;
using tramline::coverage::TransversePattern;

constexpr double kWidth = 24;

void demand(bool holds) {
  if (!holds) std::abort();
}

/// Stretches follow one another, lay nothing below 0, and lay the width in all.
void demand_sound(const TransversePattern& pattern) {
  double whole = 0, reached = pattern.right_m();
  for (const PatternStretch& stretch : pattern.within(pattern.right_m(), pattern.left_m())) {
    demand(stretch.right_m >= reached && stretch.left_m > stretch.right_m);
    demand(stretch.at_right >= 0 && stretch.at_left >= 0);
    reached = stretch.left_m;
    whole += (stretch.left_m - stretch.right_m) * (0.5 * stretch.at_right + 0.5 * stretch.at_left);
  }
  demand(std::abs(whole - kWidth) < 1e-6 * kWidth);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    tramline::io::TextLines lines(text);
    demand_sound({tramline::io::read_pattern(lines, "fuzz"), kWidth, "'fuzz'"});
  } catch (const tramline::Error&) {
    // A refusal is an answer; any other exception is a fault.
  }
  return 0;
}
