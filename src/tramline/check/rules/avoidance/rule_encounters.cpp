#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tramline/check/measure/bands.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// The pieces of each track, by subfield and track.
using Tracks = std::map<std::pair<std::size_t, int>, std::vector<std::size_t>>;

Tracks tracks_of(const Plan& plan) {
  Tracks out;
  for (std::size_t i = 0; i < plan.pieces.size(); ++i)
    out[{plan.pieces[i].subfield, plan.pieces[i].track}].push_back(i);
  return out;
}

bool extends_over(const Case& c, const TrackPiece& piece, const Detour& detour, Point at) {
  const std::optional<Path> line = replaced_line(c, piece, detour);
  return line && holds(*line, at);
}

/// The detour that passes the point of an encounter; nullptr where none does.
const Detour* detour_over(const Case& c, const Tracks& tracks, const Encounter& encounter) {
  const auto pieces = tracks.find({encounter.subfield, encounter.track});
  if (pieces == tracks.end()) return nullptr;
  for (const std::size_t i : pieces->second)
    for (const Detour& detour : c.plan.pieces[i].detours)
      if (extends_over(c, c.plan.pieces[i], detour, encounter.at)) return &detour;
  return nullptr;
}

/// Whether one of the pieces leads over a point, away from its ends.
bool driven_over(const Plan& plan, const std::vector<std::size_t>& pieces, Point at) {
  return std::any_of(pieces.begin(), pieces.end(), [&](std::size_t i) {
    const Path inner = shortened(centre_line(plan.pieces[i]), kLengthTolerance_m);
    return !inner.empty() && holds(inner, at);
  });
}

bool includes_all(const std::vector<std::size_t>& all, const std::vector<std::size_t>& some) {
  return std::all_of(some.begin(), some.end(), [&all](std::size_t index) {
    return std::find(all.begin(), all.end(), index) != all.end();
  });
}

/// For a track that follows a curve the distance of the point from the reference is checked: in corners the
/// line may be anywhere up to that distance.
bool may_lie_on_track(const Case& c, const TrackPiece& piece, Point at) {
  if (!follows_curve(c.plan, piece.subfield)) return c.lines.along(piece)->position_of(at).has_value();
  const TrackLines& lines = c.lines.of(piece.subfield);
  if (!lines.known()) return true;
  const std::vector<int> near = lines.tracks_near(at);
  return std::find(near.begin(), near.end(), piece.track) != near.end();
}

/// The fault of a track that should be cut at an encounter which no detour passes, or "".
std::string cut_fault(const Case& c, const Tracks& tracks, const Encounter& encounter) {
  const auto pieces = tracks.find({encounter.subfield, encounter.track});
  if (pieces == tracks.end()) return "";
  if (!std::all_of(pieces->second.begin(), pieces->second.end(),
                   [&](std::size_t i) { return may_lie_on_track(c, c.plan.pieces[i], encounter.at); }))
    return "does not lie on its track";
  return driven_over(c.plan, pieces->second, encounter.at) ? "was to be cut, and its track goes on there"
                                                           : "";
}

/// The contradiction between an encounter and the tracks, or "".
std::string contradiction(const Case& c, const Tracks& tracks, const Encounter& encounter) {
  const Plan& plan = c.plan;
  if (encounter.subfield >= plan.subfields.size()) return "is in a subfield that does not exist";
  // Written so that NaN is a fault.
  if (!(std::abs(encounter.at.x) <= kFarthest_m && std::abs(encounter.at.y) <= kFarthest_m))
    return "lies off the map";
  if (!exist(plan, encounter.obstacles)) return "names an obstacle that does not exist";
  const Detour* detour = detour_over(c, tracks, encounter);
  if (encounter.chosen == Passing::kCut && detour != nullptr)
    return "was to be cut, and a detour passes there";
  if (encounter.chosen == Passing::kCut) return cut_fault(c, tracks, encounter);
  if (detour == nullptr)
    return fmt::format("was to be passed {}, and no detour is there", name(encounter.chosen));
  if (detour->side != encounter.chosen)
    return fmt::format("was to be passed {}, and the detour passes {}", name(encounter.chosen),
                       name(detour->side));
  if (!includes_all(detour->obstacles, encounter.obstacles))
    return "has an obstacle that its detour does not name";
  return "";
}

}  // namespace

std::vector<const Encounter*> encounters_at(const Case& c, const TrackPiece& piece, const Detour& detour) {
  std::vector<const Encounter*> out;
  for (const Encounter& encounter : c.plan.encounters)
    if (encounter.subfield == piece.subfield && encounter.track == piece.track &&
        extends_over(c, piece, detour, encounter.at))
      out.push_back(&encounter);
  return out;
}

bool names(const std::vector<const Encounter*>& encounters, std::size_t obstacle) {
  return std::any_of(encounters.begin(), encounters.end(), [obstacle](const Encounter* encounter) {
    return std::find(encounter->obstacles.begin(), encounter->obstacles.end(), obstacle) !=
           encounter->obstacles.end();
  });
}

void check_encounters(const Case& c, Violations& out) {
  const Tracks tracks = tracks_of(c.plan);
  for (std::size_t i = 0; i < c.plan.encounters.size(); ++i) {
    const std::string fault = contradiction(c, tracks, c.plan.encounters[i]);
    if (!fault.empty())
      out.push_back(
          {Rule::kEncounters, fmt::format("encounter {} {}", i + 1, fault), c.plan.encounters[i].at, 1});
  }
}

}  // namespace tramline::check
