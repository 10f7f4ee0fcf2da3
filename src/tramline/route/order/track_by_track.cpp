#include <algorithm>
#include <limits>
#include <utility>

#include "tramline/route/order/tours.h"

namespace tramline::order {
namespace {

/// The lines of one track, along it.
using TrackLines = std::vector<std::size_t>;

std::vector<std::vector<TrackLines>> by_subfield(const std::vector<WorkedLine>& lines) {
  std::vector<std::vector<TrackLines>> out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const TrackPiece& piece = lines[i].front();
    const TrackPiece* last = i > 0 ? &lines[i - 1].front() : nullptr;
    if (last == nullptr || last->subfield != piece.subfield) out.emplace_back();
    if (last == nullptr || last->subfield != piece.subfield || last->track != piece.track)
      out.back().emplace_back();
    out.back().back().push_back(i);
  }
  return out;
}

Tour up_and_down(const std::vector<TrackLines>& tracks, bool from_last, bool downwards) {
  Tour out;
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    const TrackLines& track = tracks[from_last ? tracks.size() - 1 - k : k];
    Tour driven;
    for (const std::size_t line : track) driven.push_back(2 * line);
    if (downwards) driven = backwards(driven);
    out.insert(out.end(), driven.begin(), driven.end());
    downwards = !downwards;
  }
  return out;
}

}  // namespace

Tour track_by_track(const std::vector<WorkedLine>& lines, const HopCosts& costs) {
  std::vector<std::vector<TrackLines>> waiting = by_subfield(lines);
  Tour out;
  while (!waiting.empty()) {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t chosen = 0;
    Tour best = up_and_down(waiting.front(), false, false);
    for (std::size_t i = 0; i < waiting.size() && !out.empty(); ++i)
      for (const bool from_last : {false, true})
        for (const bool downwards : {false, true}) {
          Tour way = up_and_down(waiting[i], from_last, downwards);
          const double reach = costs.distance_m(other_end(out.back()), way.front());
          if (reach >= nearest) continue;
          nearest = reach;
          chosen = i;
          best = std::move(way);
        }
    out.insert(out.end(), best.begin(), best.end());
    waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(chosen));
  }
  return out;
}

}  // namespace tramline::order
