#pragma once
// Events of work as the page gets them.

#include <nlohmann/json.hpp>
#include <string>

#include "server/map/shown_place.h"
#include "server/work/work_frame.h"

namespace tramline::server {

struct NamedEvent {
  std::string name;  ///< frame, state, end
  nlohmann::ordered_json data;
};

/// Precondition: not std::monostate. O(vertices).
NamedEvent named_event(const WorkEvent& event, const ShownPlace& place);
nlohmann::ordered_json figures_json(const WorkFigures& figures);
/// "12,-7": column, to the east, and row, to the north.
std::string tile_id(coverage::TileIndex tile);

}  // namespace tramline::server
