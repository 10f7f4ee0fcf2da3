#include "server/map/detour_layer.h"

#include <fmt/format.h>

#include <string>

#include "server/map/few_corners.h"
#include "server/map/shown_place.h"
#include "tramline/geometry/path/path.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

std::string numbers(const std::vector<std::size_t>& obstacles) {
  std::string out;
  for (const std::size_t obstacle : obstacles)
    out += fmt::format("{}{}", out.empty() ? "" : ", ", obstacle + 1);
  return out;
}

}  // namespace

ordered_json detour_entry(const Plan& plan) {
  std::size_t count = 0;
  double m = 0;
  for (const TrackPiece& piece : plan.pieces)
    for (const Detour& detour : piece.detours) {
      ++count;
      m += length(detour.path);
    }
  return {{"name", kDetourLayer}, {"title", "Detours"}, {"features", count}, {"m2", nullptr}, {"m", m}};
}

ordered_json detour_geojson(const Plan& plan, double detail_m) {
  const ShownPlace place(plan.field.frame);
  ordered_json features = ordered_json::array();
  int order = 0;
  for (const TrackPiece& piece : plan.pieces) {
    ++order;
    for (const Detour& detour : piece.detours)
      features.push_back(feature_json("LineString", place.line(thinned_line(chords(detour.path), detail_m)),
                                      {{"order", order},
                                       {"side", name(detour.side)},
                                       {"obstacles", numbers(detour.obstacles)},
                                       {"length_m", length(detour.path)}}));
  }
  return collection_json(std::move(features));
}

}  // namespace tramline::server
