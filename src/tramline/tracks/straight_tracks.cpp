#include "tramline/tracks/straight_tracks.h"

#include <algorithm>

#include "tramline/tracks/tolerances.h"

namespace tramline {
namespace {

/// Profiles of a region that is often empty.
class Sections {
 public:
  Sections(const Region& ground, const StripGrid& grid, StripRange range, const StripMask& wanted) {
    if (!ground.empty()) profiles_ = cross_sections(ground, grid, range, wanted);
  }
  StripProfile take(std::size_t index) {
    return profiles_.empty() ? StripProfile{} : std::move(profiles_[index]);
  }

 private:
  std::vector<StripProfile> profiles_;
};

/// The stretches in which a strip leaves a hard boundary.
std::vector<Intervals> beyond_boundary(const StripGrid& grid, StripRange range, const StripMask& wanted,
                                       const Region& field) {
  if (field.empty()) return {};
  std::vector<Intervals> out(static_cast<std::size_t>(range.size()));
  const Box reach = bounds(field);
  const std::vector<StripProfile> inside = cross_sections(field, grid, range, wanted);
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = complement(where_at_least(inside[i], grid.width_m - kWidthTolerance),
                        {reach.min_y - 1, reach.max_y + 1});
  return out;
}

}  // namespace

TrackFamily straight_tracks(const StripGrid& grid, const Polygon& turned, const TurnedGround& ground,
                            const EndCriterion& criterion) {
  return straight_tracks(grid, strips_over(grid, bounds(turned), kWidthTolerance), {}, turned, ground,
                         criterion);
}

TrackFamily straight_tracks(const StripGrid& grid, StripRange range, const StripMask& wanted,
                            const Polygon& turned, const TurnedGround& ground,
                            const EndCriterion& criterion) {
  return straight_tracks(grid, range, wanted, cross_sections({turned}, grid, range, wanted), ground,
                         criterion);
}

TrackFamily straight_tracks(const StripGrid& grid, StripRange range, const StripMask& wanted,
                            std::vector<StripProfile> subfield, const TurnedGround& ground,
                            const EndCriterion& criterion) {
  Sections hard(ground.hard, grid, range, wanted), passable(ground.passable, grid, range, wanted),
      beyond(ground.beyond, grid, range, wanted);
  const std::vector<Intervals> by_outside = beyond_boundary(grid, range, wanted, ground.field);
  TrackFamily out{grid, {}};
  for (int k = range.first; k <= range.last; ++k) {
    const auto i = static_cast<std::size_t>(k - range.first);
    if (!wanted.empty() && !wanted[i]) continue;
    Track track;
    track.index = k;
    track.subfield = TrackProfile(std::move(subfield[i]));
    track.hard = TrackProfile(hard.take(i));
    track.hard_stretches = track.hard.where_at_least(kWidthTolerance);
    track.passable_stretches = where_at_least(passable.take(i), kWidthTolerance);
    track.stretches = without(allowed_by(criterion, track.subfield), track.hard_stretches);
    if (!by_outside.empty()) track.stretches = without(track.stretches, by_outside[i]);
    if (!ground.beyond.empty())
      track.stretches = without(track.stretches, where_at_least(beyond.take(i), kWidthTolerance));
    out.tracks.push_back(std::move(track));
  }
  return out;
}

}  // namespace tramline
