#pragma once
// A quick estimate of a detour before its areas are computed.

#include "tramline/avoidance/choice/track_options.h"
#include "tramline/model/objective.h"

namespace tramline {

/// The track an option belongs to, and the terms of decisions on it.
struct TrackTerms {
  std::size_t family = 0;
  const Track& track;
  const Objective& objective;
  double width_m = 0;
  double min_length_m = 0;
};

/// Whether the detour would cost several times as much as the cuts at its gaps, even if it gained all land
/// near it that no straight swath works. Other tracks count as cut. Uses profiles only: O(strips near the
/// detour). `ground` holds the land worked where pieces keep to their tracks. Only straight tracks are tested
/// for land nearby: along curves the answer is no.
bool can_be_pruned(const TrackOption& option, const TrackTerms& terms,
                   const std::vector<TrackFamily>& families, const WorkedGround& ground);

/// The same for an option valued with all other tracks cut: whether it costs so much more than the cuts it
/// saves that no choice of other tracks changes that.
bool far_too_expensive(const TrackOption& option, const TrackTerms& terms);

}  // namespace tramline
