#include "tramline/render/dose/dose_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tramline::render {
namespace {

struct Stop {
  double multiple;
  Colour colour;
};
constexpr std::array kStops = {Stop{0, rgb(kUncoveredHex)}, Stop{0.5, rgb(0x86AEEA)},
                               Stop{0.9, rgb(0xD9E8DA)},    Stop{1, rgb(0xE3EFD2)},
                               Stop{1.1, rgb(0xEFE6BF)},    Stop{1.5, rgb(0xF2A25C)},
                               Stop{2, rgb(kOverlapHex)},   Stop{kMostShown, rgb(0x6E2C00)}};

}  // namespace

Colour dose_colour(double multiple) {
  const double x = std::clamp(multiple, 0.0, kMostShown);
  std::size_t i = 1;
  while (i + 1 < kStops.size() && kStops[i].multiple < x) ++i;
  const Stop& a = kStops[i - 1];
  const Stop& b = kStops[i];
  const double share = (x - a.multiple) / (b.multiple - a.multiple);
  const auto mix = [&](double from, double to) { return (1 - share) * from + share * to; };
  return {mix(a.colour.red, b.colour.red), mix(a.colour.green, b.colour.green),
          mix(a.colour.blue, b.colour.blue), 1};
}

double opacity_off_ground(double multiple) {
  constexpr double kOpaque = 0.5;
  return std::min(1.0, std::sqrt(std::max(0.0, multiple) / kOpaque));
}

}  // namespace tramline::render
