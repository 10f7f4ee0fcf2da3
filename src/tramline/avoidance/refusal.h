#pragma once
// Why a way past an obstacle is none.

#include <cstdint>

namespace tramline {

enum class Refusal : std::uint8_t {
  kNone,  ///< it can be driven
  // Of a detour round what is in the way.
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
  // Of the paper's constructions.
  kVersleijenEndsBefore,
  kTooTight,
  kMeetsObstacle,
  kSeveralObstacles,
  kTooWide,
  kKinkedBuffer,
  kVersleijenOtherSide,
};

/// For people: "it would leave the field"; "" for kNone.
const char* sentence(Refusal refusal);

}  // namespace tramline
