#include "tramline/tracks/laid_pieces.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

#include "tramline/geometry/tolerances.h"
#include "tramline/tracks/tolerances.h"

namespace tramline {
namespace {

/// In order along the track.
[[maybe_unused]] bool sorted_and_apart(const std::vector<TrackDetour>& detours) {
  for (std::size_t i = 0; i + 1 < detours.size(); ++i)
    if (detours[i].to > detours[i + 1].from + kSameDistance_m) return false;
  return true;
}

/// The part of a joined stretch between two crossings, driven without interruption unless it is too short.
struct LaidPart {
  Interval whole;
  std::vector<TrackDetour> detours{};
  double length_m = 0;  ///< of the driven path
};

double length_of(const Interval& whole, const std::vector<TrackDetour>& detours) {
  double sum = whole.length();
  for (const TrackDetour& detour : detours) sum += detour.length_m - (detour.to - detour.from);
  return sum;
}

std::vector<LaidPart> parts_between_crossings(const JoinedStretch& joined, const Intervals& passable) {
  // A detour may go round a passable obstacle beside the hard one.
  Intervals driven_round;
  for (const TrackDetour& detour : joined.detours) driven_round.push_back({detour.from, detour.to});
  std::vector<LaidPart> parts;
  for (const Interval& whole : without({joined.whole}, without(passable, driven_round))) {
    if (whole.length() < kNoPiece_m) continue;
    LaidPart part{whole};
    for (const TrackDetour& detour : joined.detours)
      if (detour.from >= whole.from - kNoPiece_m && detour.to <= whole.to + kNoPiece_m)
        part.detours.push_back(detour);
    part.length_m = length_of(whole, part.detours);
    parts.push_back(std::move(part));
  }
  return parts;
}

/// The driven path on a curved track.
Path driven_path(const Track& track, const LaidPiece& piece) {
  Path out;
  double at = piece.from;
  const auto keep_on_until = [&](double to) {
    // A detour may begin where the one before ends.
    if (to - at < kShortest_m) return;
    Path part = path_along(track, at, to);
    if (part.empty()) return;
    if (!out.empty()) part.front().from = out.back().to;
    out.insert(out.end(), part.begin(), part.end());
  };
  for (const TrackDetour& detour : piece.detours) {
    keep_on_until(detour.from);
    if (!out.empty()) out.back().to = detour.path.front().from;
    out.insert(out.end(), detour.path.begin(), detour.path.end());
    at = detour.to;
  }
  keep_on_until(piece.to);
  return out;
}

LaidPiece piece_of(LaidPart part, const Track& track) {
  LaidPiece piece;
  piece.track = track.index;
  piece.branch = track.branch;
  piece.from = part.whole.from;
  piece.to = part.whole.to;
  piece.length_m = part.length_m;
  piece.stop_at_from = stops_at(track, part.whole.from, -1);
  piece.stop_at_to = stops_at(track, part.whole.to, +1);
  piece.detours = std::move(part.detours);
  if (!is_straight(track)) piece.path = driven_path(track, piece);
  for (const Interval& kept : parts_on_track(piece))
    piece.inside_m2 += inside_between(track, kept.from, kept.to);
  return piece;
}

void move_on(JoinedStretch& joined, double by) {
  joined.whole = {joined.whole.from + by, joined.whole.to + by};
  for (TrackDetour& detour : joined.detours) {
    detour.from += by;
    detour.to += by;
  }
}

/// The stretch before the beginning of a closed track continues behind it. A track driven all round begins
/// where work is interrupted.
void close(const Track& track, std::vector<JoinedStretch>& stretches) {
  if (stretches.empty() || stretches.front().whole.from > kNoPiece_m ||
      stretches.back().whole.to < track.length_m - kNoPiece_m)
    return;
  if (stretches.size() > 1) {
    move_on(stretches.front(), track.length_m);
    stretches.back().whole.to = stretches.front().whole.to;
    std::vector<TrackDetour>& detours = stretches.front().detours;
    std::move(detours.begin(), detours.end(), std::back_inserter(stretches.back().detours));
    stretches.erase(stretches.begin());
    return;
  }
  JoinedStretch& round = stretches.front();
  if (!round.detours.empty()) return;
  if (track.passable_stretches.empty()) {
    round.whole.to = track.length_m - kOpening_m;
    return;
  }
  const double first = track.passable_stretches.front().to;
  if (first < track.length_m - kNoPiece_m) round.whole = {first, first + track.length_m};
}

/// The stretches along a track, repeated beyond its length for a closed one.
Intervals repeated_beyond_end(const Intervals& along, double length_m) {
  Intervals out = along;
  for (const Interval& one : along) append_joining(out, {one.from + length_m, one.to + length_m});
  return out;
}

}  // namespace

Intervals parts_on_track(const LaidPiece& piece) {
  Intervals out;
  double at = piece.from;
  for (const TrackDetour& detour : piece.detours) {
    if (detour.from > at) out.push_back({at, detour.from});
    at = detour.to;
  }
  if (piece.to > at) out.push_back({at, piece.to});
  return out;
}

std::vector<Path> paths_on_track(const LaidPiece& piece) {
  assert(!piece.path.empty());
  std::vector<Path> out;
  auto at = piece.path.begin();
  for (const TrackDetour& detour : piece.detours) {
    const auto first = std::find(at, piece.path.end(), detour.path.front());
    assert(first != piece.path.end());
    if (first != at) out.emplace_back(at, first);
    at = first + static_cast<std::ptrdiff_t>(detour.path.size());
  }
  if (at != piece.path.end()) out.emplace_back(at, piece.path.end());
  return out;
}

LaidPiece cut_to(const Track& track, const LaidPiece& piece, double from, double to) {
  assert(!track.closed && piece.from <= from && from < to && to <= piece.to);
  const Interval whole{from, to};
  LaidPiece out = piece_of({whole, piece.detours, length_of(whole, piece.detours)}, track);
  out.after_crossing = piece.after_crossing;
  out.short_at_from_m = piece.short_at_from_m + (from - piece.from);
  out.short_at_to_m = piece.short_at_to_m + (piece.to - to);
  return out;
}

std::vector<JoinedStretch> joined_stretches(const Intervals& stretches,
                                            const std::vector<TrackDetour>& detours) {
  assert(sorted_and_apart(detours));
  std::vector<JoinedStretch> out;
  auto detour = detours.begin();
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    JoinedStretch joined{stretches[i]};
    for (; detour != detours.end() && detour->from <= joined.whole.to; ++detour) {
      joined.detours.push_back(*detour);
      while (i + 1 < stretches.size() && stretches[i].to < detour->to) ++i;
      joined.whole.to = stretches[i].to;
    }
    out.push_back(std::move(joined));
  }
  return out;
}

void append_joined(const Track& track, const JoinedStretch& joined, double min_length_m, LaidTracks& out) {
  std::vector<LaidPart> parts = parts_between_crossings(
      joined, track.closed ? repeated_beyond_end(track.passable_stretches, track.length_m)
                           : track.passable_stretches);
  const auto is_long = [min_length_m](const LaidPart& part) { return part.length_m >= min_length_m; };
  const auto first = std::find_if(parts.begin(), parts.end(), is_long);
  const auto last = std::find_if(parts.rbegin(), parts.rend(), is_long).base();
  for (auto part = parts.begin(); part != parts.end(); ++part) {
    const bool driven = part >= first && part < last;
    LaidPiece piece = piece_of(std::move(*part), track);
    piece.after_crossing = driven && part != first;
    (driven ? out.pieces : out.dropped).push_back(std::move(piece));
  }
}

void append_pieces(const Track& track, const std::vector<TrackDetour>& detours, double min_length_m,
                   LaidTracks& out) {
  assert(sorted_and_apart(detours));
  std::vector<JoinedStretch> stretches = joined_stretches(track.stretches, detours);
  if (track.closed) close(track, stretches);
  for (const JoinedStretch& joined : stretches) append_joined(track, joined, min_length_m, out);
}

LaidTracks cut_pieces(const TrackFamily& family, double min_length_m) {
  LaidTracks out{family.grid, {}, {}};
  for (const Track& track : family.tracks) append_pieces(track, {}, min_length_m, out);
  return out;
}

}  // namespace tramline
