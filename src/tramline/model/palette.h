#pragma once
// The colours of plans and evaluations, in pictures and in the styles of their files. Overlap and uncovered
// land are an orange and a blue that people with any of the common colour deficiencies can distinguish;
// everything else is pale or grey, so that they stand out. Land worked again or missed has the same two.

#include <array>
#include <cstdint>

namespace tramline {

/// Red, green, blue and opacity, each in [0, 1].
struct Colour {
  double red = 0;
  double green = 0;
  double blue = 0;
  double opacity = 1;
};

/// From 0xRRGGBB.
constexpr Colour rgb(std::uint32_t hex, double opacity = 1) {
  return {static_cast<double>((hex >> 16) & 0xff) / 255.0, static_cast<double>((hex >> 8) & 0xff) / 255.0,
          static_cast<double>(hex & 0xff) / 255.0, opacity};
}

inline constexpr std::uint32_t kBackgroundHex = 0xFFFFFF;
inline constexpr std::uint32_t kOverlapHex = 0xE66100;
inline constexpr std::uint32_t kUncoveredHex = 0x0A4FD6;

inline constexpr Colour kBackgroundColour = rgb(kBackgroundHex);
inline constexpr Colour kOverlapColour = rgb(kOverlapHex);
inline constexpr Colour kUncoveredColour = rgb(kUncoveredHex);
inline constexpr Colour kInk = rgb(0x1E2420);
inline constexpr Colour kFaintInk = rgb(0x5A635C);
inline constexpr Colour kRule = rgb(0xC9CDC6);
inline constexpr Colour kFieldColour = rgb(0xF1EFE8);
/// Under the passes round the field and its obstacles: distinguished from the body by being greyer, not by
/// its hue.
inline constexpr Colour kHeadlandColour = rgb(0xDEDACF);
inline constexpr std::uint32_t kHeadlandPassHex = 0x7A4E1D;
inline constexpr Colour kHeadlandPassColour = rgb(kHeadlandPassHex, 0.9);
inline constexpr Colour kReferenceColour = rgb(0x00695C);
inline constexpr Colour kReferenceRim = rgb(kBackgroundHex, 0.8);
inline constexpr Colour kFieldEdge = rgb(0x2F3B2F);
inline constexpr Colour kSubfieldEdge = rgb(0x6B7266);
inline constexpr Colour kObstacleColour = rgb(0x4C4A48);
inline constexpr Colour kObstacleHatch = rgb(0x8E8A86);
inline constexpr Colour kPassableColour = rgb(0xCFE8C4);
inline constexpr Colour kPassableHatch = rgb(0x2E8B3D);
inline constexpr Colour kGivenUpHatch = rgb(0xFFFFFF, 0.85);
inline constexpr Colour kStripe = rgb(0x2F3B2F, 0.09);
inline constexpr Colour kWorkedLandColour = rgb(0x2F3B2F, 0.06);
inline constexpr Colour kSwathEdgeColour = rgb(0x2F3B2F, 0.4);
inline constexpr Colour kKeepOffColour = kObstacleColour;
inline constexpr std::uint32_t kTrackHex = 0x3A463B;
inline constexpr Colour kTrackColour = rgb(kTrackHex, 0.85);
inline constexpr std::uint32_t kTurnHex = 0x1E7B4F;
inline constexpr Colour kTurnColour = rgb(kTurnHex);
inline constexpr std::uint32_t kNoRoomHex = 0xC62828;
inline constexpr Colour kNoRoomColour = rgb(kNoRoomHex);
inline constexpr Colour kTransitColour = rgb(0x8C299E);
inline constexpr Colour kBackOutColour = rgb(0x1F1F29);
inline constexpr Colour kRouteStartColour = rgb(0x1A8C38);
inline constexpr Colour kRouteEndColour = rgb(0xB81F1F);
inline constexpr Colour kDroppedColour = rgb(0x6E6E6E);
// Darker than overlap and uncovered land, and drawn on a white rim: its shape tells it apart from them
// even where its hue does not.
inline constexpr std::uint32_t kDetourHex = 0x9A0F72;
inline constexpr Colour kDetourColour = rgb(kDetourHex);
inline constexpr Colour kRadiusColour = rgb(kDetourHex, 0.85);
inline constexpr Colour kDetourRim = rgb(kBackgroundHex, 0.9);

/// Covered land, inside the field and beyond it.
inline constexpr std::uint32_t kCoveredHex = 0xBFDDA9;
inline constexpr std::uint32_t kCoveredOutsideHex = 0xE4F0DA;
inline constexpr Colour kCoveredColour = rgb(kCoveredHex);
inline constexpr Colour kCoveredOutsideColour = rgb(kCoveredOutsideHex);
inline constexpr Colour kCoveredEdge = rgb(0x86AE6B);
inline constexpr Colour kTwiceHatch = rgb(0x8A3B00);
/// Land that may have been worked and was not recorded: a yellow under dark lines, unlike worked and missed
/// land.
inline constexpr std::uint32_t kNotRecordedHex = 0xF2C500;
inline constexpr Colour kNotRecordedColour = rgb(kNotRecordedHex);
inline constexpr Colour kNotRecordedHatch = rgb(0x1E2420, 0.55);
inline constexpr Colour kWorkedPathColour = rgb(0x26402A, 0.75);
inline constexpr Colour kIdlePathColour = rgb(0x7B7B7B, 0.8);

/// The number of gaps, the largest, that are numbered.
inline constexpr int kGapsNumbered = 12;

/// Tints of the subfields, used in turn.
inline constexpr std::array<Colour, 8> kTints = {rgb(0xE2EDD5), rgb(0xF4EACB), rgb(0xE7DFF0), rgb(0xF3DDDB),
                                                 rgb(0xD3EAE5), rgb(0xEAE9C4), rgb(0xDCE3EC), rgb(0xEADCCB)};
constexpr Colour tint(std::size_t subfield) { return kTints[subfield % kTints.size()]; }

}  // namespace tramline
