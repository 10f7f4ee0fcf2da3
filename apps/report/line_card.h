#pragma once
// What a line card says, in words.

#include <string>
#include <vector>

#include "tramline/geometry/point.h"
#include "tramline/model/plan.h"

namespace tramline::app {

/// "52.6931451° N, 9.1477443° E, or 52° 41.58871' N, 9° 8.86466' E": seven decimals of a degree, five of a
/// minute, which are about a centimetre and two.
std::string position_text(Point lonlat);

/// "1 to 5, 8, 7, 3": numbers in their order; three or more that follow one another up or down are a run.
std::string runs_text(const std::vector<int>& numbers);

/// A line that tracks are counted from.
struct CountedFrom {
  std::string name;
  std::size_t subfield = 0;
  int track = 0;  ///< the one that the line lies on
  Point a, b;
};

/// Working width, headland passes, hours, and in which order the tracks are driven: counted from the line, as
/// displays do, to the right of it as one drives from A to B, and to the left with a minus.
std::vector<std::string> card_rows(const Plan& plan, const std::vector<CountedFrom>& lines);

}  // namespace tramline::app
