#include "options/drive_options.h"

#include <fmt/format.h>

#include <cstdlib>

namespace tramline::app {
namespace {

/// Wider than anything that drives or flies over a field, m.
constexpr double kWidest_m = 1000;

std::string sensible_width(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || *end != '\0' || !(value > 0 && value <= kWidest_m))
    return fmt::format("has to be more than 0 and at most {:g} m, not {}", kWidest_m, text);
  return "";
}

}  // namespace

void add_drive_options(Verb& verb, DriveOptions& options) {
  coverage::DriveSettings& drive = options.drive;
  verb.add_option("--width", drive.width_m, "working width where the log has none, m").check(sensible_width);
  verb.add_option("--columns", options.log.columns,
                  "which column is what, where names do not say: \"lon=Xcoord,lat=Ycoord,time=T\"");
  verb.add_option("--log-crs", options.log.crs,
                  "CRS of the log's x and y, such as EPSG:25832; 'none' for plain metres");
  verb.add_option(
          "--quads", options.quads,
          "ground of a step: 'heading', square to the heading at either end, or 'segment', a rectangle "
          "along the step")
      .one_of({"heading", "segment"})
      .shows_default();
  verb.add_option("--switch", options.switching,
                  "when work and sections switch: 'interpolate', half way between fixes, or 'step', at the "
                  "second")
      .one_of({"interpolate", "step"})
      .shows_default();
  verb.add_option("--max-gap-s", drive.max_gap_s, "nothing is worked over longer gaps in time, s")
      .positive()
      .shows_default();
  verb.add_option("--max-step-m", drive.max_step_m, "nor over longer steps, m").positive().shows_default();
  verb.add_option("--antenna-forward", drive.antenna_forward_m, "antenna before the machine's middle, m")
      .in_range(-100.0, 100.0)
      .shows_default();
  verb.add_option("--antenna-right", drive.antenna_right_m, "antenna right of it, m")
      .in_range(-100.0, 100.0)
      .shows_default();
  verb.add_option("--implement-behind", drive.implement_behind_m,
                  "what works, behind the machine's middle, m")
      .in_range(-100.0, 100.0)
      .shows_default();
  verb.add_option(
          "--repeat", options.repeat,
          "what is repeated: 'run', ground worked before the machine's own trail, or 'strict', all ground "
          "worked twice")
      .one_of({"run", "strict"})
      .shows_default();
}

}  // namespace tramline::app
