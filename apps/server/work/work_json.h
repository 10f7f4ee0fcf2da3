#pragma once
// Events of work as the page gets them.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "server/map/shown_place.h"
#include "server/work/work_frame.h"

namespace tramline::server {

struct NamedEvent {
  std::string name;  ///< frame, state, end
  nlohmann::ordered_json data;
};

/// Puts places on the map of the page. One object on one thread at a time.
class EventWriter {
 public:
  /// Precondition: not std::monostate. O(vertices).
  NamedEvent named(const WorkEvent& event);

 private:
  nlohmann::ordered_json frame_json(const WorkFrame& frame);
  LocalFrame plane_;
  std::optional<ShownPlace> place_;  ///< of plane_
};

nlohmann::ordered_json figures_json(const WorkFigures& figures);
/// "12,-7": column, to the east, and row, to the north.
std::string tile_id(coverage::TileIndex tile);

}  // namespace tramline::server
