#include "tramline/route/passes/passes_round_obstacles.h"

#include <algorithm>
#include <limits>

namespace tramline {
namespace {

/// A track that ends no farther from a pass turns on its land.
constexpr double kBeside_widths = 1.5;

double distance_to(const std::vector<Point>& places, Point p) {
  double out = std::numeric_limits<double>::infinity();
  for (const Point place : places) out = std::min(out, distance(p, place));
  return out;
}

bool ends_beside(const DrivenTrack& track, const std::vector<Point>& places, double width_m) {
  return std::ranges::any_of(*track.pieces, [&](const TrackPiece& piece) {
    return std::min(distance_to(places, piece.start), distance_to(places, piece.end)) <
           kBeside_widths * width_m;
  });
}

/// By how much the straight way between two places is longer by way of one of these.
double aside_m(Point from, Point to, const std::vector<Point>& places) {
  double out = std::numeric_limits<double>::infinity();
  for (const Point place : places) out = std::min(out, distance(from, place) + distance(place, to));
  return out - distance(from, to);
}

/// Those of the passes that share a boundary with one of the group, and those that share one with these, and
/// so on.
std::vector<std::size_t> along_boundaries_of(std::vector<std::size_t> group, std::vector<std::size_t>& others,
                                             const Headland& headland) {
  for (std::size_t i = 0; i < group.size(); ++i)
    std::erase_if(others, [&](std::size_t other) {
      if (!along_one_boundary(headland.passes[group[i]], headland.passes[other])) return false;
      group.push_back(other);
      return true;
    });
  return group;
}

bool goes_round_obstacles_alone(const HeadlandPass& pass) { return is_closed(pass) && !pass.around_field; }

}  // namespace

std::vector<std::vector<std::size_t>> passes_round_obstacles(const Headland& headland,
                                                             const std::vector<std::size_t>& passes) {
  std::vector<std::vector<std::size_t>> out;
  for (std::vector<std::size_t> others = passes; !others.empty();) {
    const std::size_t first = others.front();
    others.erase(others.begin());
    std::vector<std::size_t> group = along_boundaries_of({first}, others, headland);
    std::ranges::sort(group);
    if (std::ranges::all_of(
            group, [&](std::size_t pass) { return goes_round_obstacles_alone(headland.passes[pass]); }))
      out.push_back(std::move(group));
  }
  return out;
}

std::optional<std::size_t> track_before(const std::vector<DrivenTrack>& tracks,
                                        const std::vector<Point>& places, double width_m) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < tracks.size(); ++i)
    if (ends_beside(tracks[i], places, width_m)) first = i;
  std::optional<std::size_t> out;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = first; i + 1 < tracks.size(); ++i) {
    const double by_m = aside_m(tracks[i].left.at, tracks[i + 1].entered.at, places);
    if (by_m >= least_m) continue;
    least_m = by_m;
    out = i;
  }
  return out;
}

}  // namespace tramline
