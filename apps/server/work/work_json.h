#pragma once
// Events of work in the format for the page.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "server/map/shown_place.h"
#include "server/work/work_frame.h"

namespace tramline::server {

struct NamedEvent {
  std::string name;  ///< frame, state, end
  std::string data;  ///< JSON
};

/// Puts places on the map of the page. One object on one thread at a time.
///
/// `detail_m`: lines and outlines keep within that of what they are, and what is narrower may go; places are
/// then given to the millimetre. 0: nothing is left out. Figures are always those of all of it.
class EventWriter {
 public:
  explicit EventWriter(double detail_m = 0) : detail_m_(detail_m) {}
  /// Precondition: not std::monostate. Mostly O(n log n) in vertices.
  NamedEvent named(const WorkEvent& event);

 private:
  std::string frame_text(const WorkFrame& frame);
  double detail_m_;
  LocalFrame plane_;
  std::optional<ShownPlace> place_;  ///< of plane_
};

nlohmann::ordered_json figures_json(const WorkFigures& figures);
/// "12,-7": column, to the east, and row, to the north.
std::string tile_id(coverage::TileIndex tile);

}  // namespace tramline::server
