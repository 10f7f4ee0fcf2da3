#include "tramline/headland/passages/narrow_passages.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "tramline/headland/closed_path.h"
#include "tramline/headland/drivable_rings.h"
#include "tramline/headland/rolling_circle_path.h"
#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

/// The part of a centre line on which a piece of a ring lies.
struct NarrowRun {
  std::size_t centre_line = 0;
  double from = 0;
  double to = 0;
};

/// A part of a ring along consecutive centre lines. At its end the circle touches something farther ahead.
struct Stretch {
  CentrePosition from;
  CentrePosition to;
  OffsetRing pieces;
  std::size_t after = 0;  ///< the next stretch of the ring
  std::size_t along = 0;  ///< the next stretch along the offset line
};

/// The continuation of a ring after a stretch.
struct Link {
  std::size_t to = 0;
  OffsetRing way;
};

double metres(const CentreLine& centre_line, double extent) {
  return centre_line.curve.straight() ? extent : extent * centre_line.curve.radius;
}

/// Distance by which pieces of a ring may end before or behind their centre lines, m: where edges turn too
/// little for a corner their offset lines just go on, so lines at two distances end up to this share of the
/// difference apart.
double slack_m(double radius_m) { return kSamePlace_m + kNoCorner_rad * radius_m; }

/// The part of the centre line on which the piece lies; nullopt where it is not on it.
std::optional<NarrowRun> run_on(const CentreLine& centre_line, std::size_t index, const OffsetPiece& piece,
                                double radius_m) {
  const OffsetCurve& curve = centre_line.curve;
  if (curve.straight() != piece.segment.straight() || centre_line.offset_boundary != piece.offset_boundary)
    return std::nullopt;
  if (!curve.straight() && distance(curve.centre, piece.centre) > kSamePlace_m) return std::nullopt;
  Box box;
  box.extend(midpoint(piece.segment.from, piece.segment.to));
  if (!intersects(curve.box.grown(curve.radius + 1), box)) return std::nullopt;
  for (const Point p : {piece.segment.from, piece.segment.to}) {
    const double position = position_on(curve, p);
    if (distance(point_at(curve, position), p) > kSamePlace_m) return std::nullopt;
    if (metres(centre_line, position) < -slack_m(radius_m) ||
        metres(centre_line, position - curve.extent) > slack_m(radius_m))
      return std::nullopt;
  }
  if (dot(heading_at(curve, piece.segment.from), piece.from_heading) < 0) return std::nullopt;
  const auto within = [&](Point p) { return std::clamp(position_on(curve, p), 0.0, curve.extent); };
  return NarrowRun{index, within(piece.segment.from), within(piece.segment.to)};
}

bool run_on_to(const std::vector<CentreLine>& centre_lines, const NarrowRun& before, const NarrowRun& after,
               double radius_m) {
  const CentreLine &a = centre_lines[before.centre_line], &b = centre_lines[after.centre_line];
  if (before.centre_line == after.centre_line)
    return std::abs(metres(a, after.from - before.to)) < kSamePlace_m;
  return a.next == after.centre_line &&
         metres(a, a.curve.extent - before.to) + metres(b, after.from) < slack_m(radius_m);
}

/// Splits a ring into stretches. False where it is not on the centre lines.
bool append_stretches(const OffsetRing& ring, const std::vector<CentreLine>& centre_lines, double radius_m,
                      std::vector<Stretch>& out) {
  std::vector<NarrowRun> runs;
  std::vector<const OffsetPiece*> pieces;
  for (const OffsetPiece& piece : ring) {
    std::optional<NarrowRun> run;
    for (std::size_t i = 0; i < centre_lines.size() && !run; ++i)
      run = run_on(centre_lines[i], i, piece, radius_m);
    if (!run && length(piece.segment) > kOffCentreLines_m) return false;
    if (!run) continue;
    runs.push_back(*run);
    pieces.push_back(&piece);
  }
  const std::size_t n = runs.size(), first = out.size();
  const auto breaks_before = [&](std::size_t i) {
    return !run_on_to(centre_lines, runs[(i + n - 1) % n], runs[i], radius_m);
  };
  std::size_t start = 0;
  while (start < n && !breaks_before(start)) ++start;
  if (n == 0) return false;
  if (start == n) {  // no turn at all
    out.push_back({{runs[0].centre_line, runs[0].from}, {runs[0].centre_line, runs[0].from}, ring, first, 0});
    return true;
  }
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (start + k) % n;
    if (breaks_before(i)) out.push_back({{runs[i].centre_line, runs[i].from}, {}, {}, out.size() + 1, 0});
    out.back().to = {runs[i].centre_line, runs[i].to};
    out.back().pieces.push_back(*pieces[i]);
  }
  out.back().after = first;
  return true;
}

/// Finds the next stretch along the offset line. Centre lines of one ring are consecutive in the list.
void order_along(const std::vector<CentreLine>& centre_lines, std::vector<Stretch>& stretches) {
  std::vector<std::size_t> order(stretches.size()), ring(centre_lines.size(), 0);
  for (std::size_t i = 1; i < centre_lines.size(); ++i)
    ring[i] = centre_lines[i - 1].next == i ? ring[i - 1] : i;
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto position = [&](std::size_t i) {
    return std::pair(stretches[i].from.centre_line, stretches[i].from.at);
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return position(i) < position(j); });
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() &&
           ring[stretches[order[last]].from.centre_line] == ring[stretches[order[first]].from.centre_line])
      ++last;
    for (std::size_t i = first; i < last; ++i)
      stretches[order[i]].along = order[i + 1 < last ? i + 1 : first];
  }
}

/// Groups of stretches whose ends may continue along the offset line instead of turning: if all of a group
/// do, the results are rings again.
std::vector<std::vector<std::size_t>> passages_between(const std::vector<Stretch>& stretches) {
  std::vector<std::size_t> before(stretches.size());
  for (std::size_t i = 0; i < stretches.size(); ++i) before[stretches[i].after] = i;
  std::vector<bool> seen(stretches.size(), false);
  std::vector<std::vector<std::size_t>> out;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    std::vector<std::size_t> group;
    for (std::size_t k = i; !seen[k]; k = before[stretches[k].along]) {
      seen[k] = true;
      group.push_back(k);
    }
    if (group.size() > 1) out.push_back(std::move(group));
  }
  return out;
}

std::vector<OffsetRing> traced(const std::vector<Stretch>& stretches, const std::vector<Link>& links) {
  std::vector<bool> seen(stretches.size(), false);
  std::vector<OffsetRing> out;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    OffsetRing ring;
    for (std::size_t k = i; !seen[k]; k = links[k].to) {
      seen[k] = true;
      ring.insert(ring.end(), stretches[k].pieces.begin(), stretches[k].pieces.end());
      ring.insert(ring.end(), links[k].way.begin(), links[k].way.end());
    }
    if (!ring.empty()) out.push_back(std::move(ring));
  }
  return out;
}

/// The longest centre line of each ring of the offset line that no ring of centres touches.
std::vector<std::size_t> idle_offset_lines(const std::vector<CentreLine>& centre_lines,
                                           const std::vector<Stretch>& stretches) {
  std::vector<std::size_t> out;
  for (std::size_t first = 0; first < centre_lines.size();) {
    std::size_t last = first, longest = first;
    do {
      if (metres(centre_lines[last], centre_lines[last].curve.extent) >
          metres(centre_lines[longest], centre_lines[longest].curve.extent))
        longest = last;
      ++last;
    } while (last < centre_lines.size() && centre_lines[last - 1].next == last);
    if (std::none_of(stretches.begin(), stretches.end(), [&](const Stretch& stretch) {
          return stretch.from.centre_line >= first && stretch.from.centre_line < last;
        }))
      out.push_back(longest);
    first = last;
  }
  return out;
}

/// The line of the centre all round a ring of the offset line, starting on a centre line along which the
/// circle rolls for some length.
std::optional<OffsetRing> rolled_round(const std::vector<CentreLine>& centre_lines, std::size_t start,
                                       const ArcFits& fits) {
  const double from = 0.4 * centre_lines[start].curve.extent, to = 0.6 * centre_lines[start].curve.extent;
  std::optional<OffsetRing> out = rolling_circle_path(centre_lines, {start, to}, {start, from}, fits);
  if (out) out->push_back(piece_between(centre_lines[start], from, to));
  return out;
}

/// The rings chosen so far.
class Choice {
 public:
  Choice(std::vector<OffsetRing> rings, const TurningRoom& land, const BetterRings& better)
      : rings_(std::move(rings)), land_(land), better_(better) {}

  /// Rings that cannot be driven are not adopted.
  bool adopt_if_better(std::vector<OffsetRing> rings) {
    if (!better_(rings, rings_)) return false;
    for (const OffsetRing& ring : rings)
      if (!can_be_driven(closed_path(ring, land_.radius_m), land_)) return false;
    rings_ = std::move(rings);
    return true;
  }
  const std::vector<OffsetRing>& rings() const { return rings_; }

 private:
  std::vector<OffsetRing> rings_;
  const TurningRoom& land_;
  const BetterRings& better_;
};

}  // namespace

std::vector<OffsetRing> joined_through_narrow_passages(std::vector<OffsetRing> centres,
                                                       const TurningRoom& land, const BetterRings& better) {
  if (land.offset_boundaries.size() < 2 && centres.size() < 2) return centres;
  const std::vector<CentreLine> centre_lines = centre_lines_along(offset_lines(land), land.radius_m);
  std::vector<Stretch> stretches;
  for (const OffsetRing& ring : centres)
    if (!append_stretches(ring, centre_lines, land.radius_m, stretches)) return centres;
  order_along(centre_lines, stretches);
  const ArcFits fits = [&](Point centre, Point before, Point after) {
    return keeps_off(turn_about(centre, land.radius_m, before, after), land.offset_boundaries);
  };
  const auto passages = passages_between(stretches);
  const std::vector<std::size_t> idle = land.offset_boundaries.size() > 1
                                            ? idle_offset_lines(centre_lines, stretches)
                                            : std::vector<std::size_t>{};
  if (passages.empty() && idle.empty()) return centres;

  Choice choice(std::move(centres), land, better);
  std::vector<Link> links;
  for (const Stretch& stretch : stretches) links.push_back({stretch.after, {}});
  for (const std::vector<std::size_t>& passage : passages) {
    std::vector<Link> changed = links;
    bool passes = true;
    for (const std::size_t k : passage) {
      const std::size_t to = stretches[k].along;
      std::optional<OffsetRing> way =
          passes ? rolling_circle_path(centre_lines, stretches[k].to, stretches[to].from, fits)
                 : std::nullopt;
      passes = way.has_value();
      if (passes) changed[k] = {to, std::move(*way)};
    }
    if (!passes) continue;
    if (choice.adopt_if_better(traced(stretches, changed))) links = std::move(changed);
  }
  for (const std::size_t centre_line : idle) {
    const std::optional<OffsetRing> ring = rolled_round(centre_lines, centre_line, fits);
    if (!ring) continue;
    std::vector<OffsetRing> rings = choice.rings();
    rings.push_back(*ring);
    choice.adopt_if_better(std::move(rings));
  }
  return choice.rings();
}

}  // namespace tramline
