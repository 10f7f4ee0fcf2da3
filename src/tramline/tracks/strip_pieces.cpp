#include "tramline/tracks/strip_pieces.h"

#include <algorithm>
#include <cassert>

namespace tramline {
namespace {

/// One after the other along the track.
[[maybe_unused]] bool sorted_and_apart(const std::vector<StripDetour>& detours) {
  for (std::size_t i = 0; i + 1 < detours.size(); ++i)
    if (detours[i].to > detours[i + 1].from + 1e-9) return false;
  return true;
}

double length_of(const Interval& whole, const std::vector<StripDetour>& detours) {
  double sum = whole.length();
  for (const StripDetour& detour : detours) sum += detour.length_m - (detour.to - detour.from);
  return sum;
}

std::vector<LaidPart> parts_between_crossings(const JoinedStretch& joined, const Intervals& passable) {
  // A detour may go round a passable obstacle beside the hard one.
  Intervals driven_round;
  for (const StripDetour& detour : joined.detours) driven_round.push_back({detour.from, detour.to});
  std::vector<LaidPart> parts;
  for (const Interval& whole : without({joined.whole}, without(passable, driven_round))) {
    if (whole.length() < kNoPiece_m) continue;
    LaidPart part{whole};
    for (const StripDetour& detour : joined.detours)
      if (detour.from >= whole.from - kNoPiece_m && detour.to <= whole.to + kNoPiece_m)
        part.detours.push_back(detour);
    part.length_m = length_of(whole, part.detours);
    parts.push_back(std::move(part));
  }
  return parts;
}

StripPiece piece_of(LaidPart part, const Strip& strip) {
  StripPiece piece;
  piece.strip = strip.index;
  piece.from = part.whole.from;
  piece.to = part.whole.to;
  piece.stop_at_from = stops_at(strip, part.whole.from, -1);
  piece.stop_at_to = stops_at(strip, part.whole.to, +1);
  piece.after_crossing = part.after_crossing;
  piece.detours = std::move(part.detours);
  for (const Interval& straight : straight_parts(piece))
    piece.inside_m2 += area_between(strip.subfield, straight.from, straight.to);
  return piece;
}

}  // namespace

Intervals straight_parts(const StripPiece& piece) {
  Intervals out;
  double at = piece.from;
  for (const StripDetour& detour : piece.detours) {
    if (detour.from > at) out.push_back({at, detour.from});
    at = detour.to;
  }
  if (piece.to > at) out.push_back({at, piece.to});
  return out;
}

std::vector<JoinedStretch> joined_stretches(const Intervals& stretches,
                                            const std::vector<StripDetour>& detours) {
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

double length(const StripPiece& piece) { return length_of({piece.from, piece.to}, piece.detours); }

std::vector<LaidPart> laid_parts(const JoinedStretch& joined, const Intervals& passable,
                                 double min_length_m) {
  std::vector<LaidPart> parts = parts_between_crossings(joined, passable);
  const auto is_long = [min_length_m](const LaidPart& part) { return part.length_m >= min_length_m; };
  const auto first = std::find_if(parts.begin(), parts.end(), is_long);
  const auto last = std::find_if(parts.rbegin(), parts.rend(), is_long).base();
  for (auto part = parts.begin(); part != parts.end(); ++part) {
    part->driven = part >= first && part < last;
    part->after_crossing = part->driven && part != first;
  }
  return parts;
}

void append_joined(const Strip& strip, const JoinedStretch& joined, double min_length_m,
                   SubfieldTracks& out) {
  for (LaidPart& part : laid_parts(joined, strip.by_passable, min_length_m)) {
    const bool driven = part.driven;
    (driven ? out.pieces : out.dropped).push_back(piece_of(std::move(part), strip));
  }
}

void append_pieces(const Strip& strip, const std::vector<StripDetour>& detours, double min_length_m,
                   SubfieldTracks& out) {
  assert(sorted_and_apart(detours));
  for (const JoinedStretch& joined : joined_stretches(strip.stretches, detours))
    append_joined(strip, joined, min_length_m, out);
}

SubfieldTracks cut_pieces(const Strips& strips, double min_length_m) {
  SubfieldTracks out{strips.grid, {}, {}};
  for (const Strip& strip : strips.strips) append_pieces(strip, {}, min_length_m, out);
  return out;
}

}  // namespace tramline
