#include "report/line_card.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "tramline/model/headland.h"
#include "tramline/model/route.h"

namespace tramline::app {
namespace {

constexpr double kSecondsAnHour = 3600;

/// One coordinate with the letter of its side: "52.6931451° N".
std::string degrees_text(double degrees, char positive, char negative) {
  return fmt::format("{:.7f}° {}", std::abs(degrees), degrees < 0 ? negative : positive);
}

/// Rounded as a whole, so that no minute is 60.
std::string minutes_text(double degrees, char positive, char negative) {
  constexpr double kParts = 1e5;
  const double parts = std::round(std::abs(degrees) * 60 * kParts);
  const double whole = std::floor(parts / (60 * kParts));
  return fmt::format("{:.0f}° {:.5f}' {}", whole, parts / kParts - 60 * whole,
                     degrees < 0 ? negative : positive);
}

std::string hours_row(const Plan& plan) {
  if (plan.route.planned()) {
    const RouteSums sums = sums_of(plan.route);
    return fmt::format("Time: {:.2f} h for {:.2f} km of route, turns and ways included.",
                       sums.time_s / kSecondsAnHour, sums.length_m / 1000);
  }
  const double way_m = plan.tally.track_length_m + length(plan.headland);
  return fmt::format(
      "Time at work: {:.2f} h for {:.2f} km at {:g} m/s; turns come on top, no route is planned.",
      way_m / plan.machine.turning.working_speed_mps / kSecondsAnHour, way_m / 1000,
      plan.machine.turning.working_speed_mps);
}

std::string headland_row(const Plan& plan) {
  const std::size_t passes = plan.headland.passes.size();
  if (passes == 0) return "Headland: none.";
  const bool first = plan.route.planned() && plan.settings.route.passes == PassTime::kFirst;
  const char* const when = !plan.route.planned() ? "" : first ? ", before the tracks" : ", after the tracks";
  return fmt::format("Headland: {} pass{}, {:.2f} km{}.", passes, passes == 1 ? "" : "es",
                     length(plan.headland) / 1000, when);
}

/// The tracks of the line's subfield in driving order, each once for pieces in succession.
std::vector<int> counted(const Plan& plan, const CountedFrom& line) {
  std::vector<int> out;
  int right = 1;  // of the numbers of tracks
  for (const TrackPiece& piece : plan.pieces)
    if (piece.subfield == line.subfield && piece.track != line.track) {
      const bool is_right = cross(line.b - line.a, midpoint(piece.start, piece.end) - line.a) < 0;
      right = is_right == (piece.track > line.track) ? 1 : -1;
      break;
    }
  for (const TrackPiece& piece : plan.pieces) {
    if (piece.subfield != line.subfield) continue;
    const int number = right * (piece.track - line.track);
    if (out.empty() || out.back() != number) out.push_back(number);
  }
  return out;
}

}  // namespace

std::string position_text(Point lonlat) {
  return fmt::format("{}, {}, or {}, {}", degrees_text(lonlat.y, 'N', 'S'), degrees_text(lonlat.x, 'E', 'W'),
                     minutes_text(lonlat.y, 'N', 'S'), minutes_text(lonlat.x, 'E', 'W'));
}

std::string runs_text(const std::vector<int>& numbers) {
  std::string out;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    const int step = i + 1 < numbers.size() ? numbers[i + 1] - numbers[i] : 0;
    while (std::abs(step) == 1 && last + 1 < numbers.size() && numbers[last + 1] - numbers[last] == step)
      ++last;
    if (last < i + 2) last = i;
    if (!out.empty()) out += ", ";
    out += last == i ? std::to_string(numbers[i]) : fmt::format("{} to {}", numbers[i], numbers[last]);
    i = last + 1;
  }
  return out;
}

std::vector<std::string> card_rows(const Plan& plan, const std::vector<CountedFrom>& lines) {
  std::vector<std::string> out = {fmt::format("Working width: {:g} m.", plan.machine.width_m),
                                  headland_row(plan), hours_row(plan)};
  for (const CountedFrom& line : lines)
    out.push_back(
        fmt::format("Order of the tracks, counted from {} to the right of A-B, to the left with a minus: {}.",
                    line.name, runs_text(counted(plan, line))));
  return out;
}

}  // namespace tramline::app
