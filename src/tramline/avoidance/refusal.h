#pragma once
// Reasons for refusing a way past an obstacle.

#include <cstdint>

namespace tramline {

enum class Refusal : std::uint8_t {
  kNone,  ///< it can be driven
  // Reasons for a detour round what is in the way.
  kNoRoomBetween,
  kNotBlocked,
  kNoWayBack,
  kNoSide,
  kEndsBefore,
  kLeavesField,
  kPassesHardBoundary,
  kEntersPassable,
  kFarTooExpensive,
  kBesideOthers,
  kNotWorthTheWay,
  // Reasons for the paper's constructions.
  kVersleijenEndsBefore,
  kTooTight,
  kNoRoomBeside,
  kMeetsObstacle,
  kSeveralObstacles,
  kTooWide,
  kVersleijenOtherSide,
};

/// The reason in words: "it would leave the field"; "" for kNone.
const char* sentence(Refusal refusal);

}  // namespace tramline
