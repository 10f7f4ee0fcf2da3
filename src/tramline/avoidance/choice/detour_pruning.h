#pragma once
// A quick look at a detour before its areas are computed.

#include "tramline/avoidance/choice/track_options.h"
#include "tramline/model/objective.h"

namespace tramline {

/// The track an option belongs to, and what decisions on it are made by.
struct TrackTerms {
  std::size_t family = 0;
  const Track& track;
  const Objective& objective;
  double width_m = 0;
  double min_length_m = 0;
};

/// Would the detour cost several times what the cuts at its gaps do, even if all ground near it that no
/// straight swath works were gained by it? Other tracks taken as cut. Looks at profiles only: O(strips near
/// the detour). `ground` holds what all tracks work where they are kept to. Only straight tracks are asked
/// for ground near by: along curves the answer is no.
bool can_be_pruned(const TrackOption& option, const TrackTerms& terms,
                   const std::vector<TrackFamily>& families, const WorkedGround& ground);

/// The same of an option that has been valued with all other tracks cut: does it cost so much more than
/// the cuts it saves that what other tracks do will not change that?
bool far_too_expensive(const TrackOption& option, const TrackTerms& terms);

}  // namespace tramline
