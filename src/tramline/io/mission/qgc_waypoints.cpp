#include <fmt/format.h>

#include <iterator>

#include "tramline/io/mission/route_texts.h"

namespace tramline::io {
namespace {

/// Number, whether it is the current one, frame, command, four parameters, latitude, longitude, altitude, and
/// whether to go on by itself.
void add_row(std::string& text, std::size_t number, const MissionItem& item) {
  const auto param = [&](std::size_t i) { return item.params[i].value_or(0); };
  fmt::format_to(std::back_inserter(text),
                 "{}\t{}\t{}\t{}\t{:.6f}\t{:.6f}\t{:.6f}\t{:.6f}\t{:.9f}\t{:.9f}\t{:.3f}\t1\n", number,
                 number == 0 ? 1 : 0, item.frame, item.command, param(0), param(1), param(2), param(3),
                 param(4), param(5), param(6));
}

}  // namespace

std::string qgc_waypoints_text(const Mission& mission) {
  std::string out = "QGC WPL 110\n";
  constexpr int kOnTheGlobe = 0;  // home: altitude above the sea, which is not known here
  add_row(out, 0,
          {mavlink::kWaypoint, kOnTheGlobe, {0, 0, 0, 0, mission.home_lonlat.y, mission.home_lonlat.x, 0}});
  for (std::size_t i = 0; i < mission.items.size(); ++i) add_row(out, i + 1, mission.items[i]);
  return out;
}

}  // namespace tramline::io
