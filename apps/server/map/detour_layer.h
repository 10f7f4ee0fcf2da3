#pragma once
// Ways round obstacles as a layer of their own: a plan file has them as parts of its tracks only.

#include <nlohmann/json.hpp>

#include "tramline/model/plan.h"

namespace tramline::server {

inline constexpr const char* kDetourLayer = "detours";

/// For the list of layers: how many, and how long they are together, m.
nlohmann::ordered_json detour_entry(const Plan& plan);

/// Lines in longitude and latitude, arcs as chords, in driving order: order (of the track, from 1), side,
/// obstacles ("3, 7", as in the layer tracks), length_m. Lines deviate by `detail_m` at most. O(n) in
/// segments.
nlohmann::ordered_json detour_geojson(const Plan& plan, double detail_m);

}  // namespace tramline::server
