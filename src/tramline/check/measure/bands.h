#pragma once
// The ground along paths, segment by segment: a path that comes back to itself has one, too.

#include <cstdint>

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::check {

/// Straight segments only, of which two meet at an angle of more than kLeastKink.
bool is_kinked(const Path& path);

/// Does ground lie flat for certain? Where its path is too tight or has kinks it folds over itself.
enum class Folds : std::uint8_t { kNever, kPerhaps };

/// A polygon of worked ground. Of one that folds over itself what it encloses counts.
void append_ground(Ring ring, Folds folds, Region& out);

/// The band of every segment, one after the other; they touch, and overlap where the path comes back. At
/// kinks of straight segments they are cut or lengthened to the kink's bisector, so that each has the area
/// width · length; kinks of more than 120°, and those beside a segment whose bisectors meet within its band,
/// have flat ends.
Region bands_along(const Path& path, double width_m, double sagitta_m = kChordSagitta);

/// The same with every segment by itself and flat ends, kinks or not: what headland passes are counted by.
Region flat_bands_along(const Path& path, double width_m, double sagitta_m = kChordSagitta);

/// The path without the first metres; empty where nothing is left.
Path begun_later(const Path& path, double by_m);

/// The path without the first and the last `by_m`; empty where nothing is left.
Path shortened(const Path& path, double by_m);

/// The place so far from the beginning of a segment, and the heading there (a unit vector).
Point place_on(const PathSegment& segment, double along_m);
Point heading_on(const PathSegment& segment, double along_m);

/// The place `along_m` from the beginning of a path, or its end where that is nearer.
Point place_on(const Path& path, double along_m);

/// Length of all arcs, m.
double arcs_m(const Path& path);

}  // namespace tramline::check
