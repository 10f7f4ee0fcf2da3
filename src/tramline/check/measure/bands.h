#pragma once
// The land along paths, segment by segment, including paths that come back to themselves.

#include <cstdint>

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/headland.h"

namespace tramline::check {

/// Whether the path consists of straight segments only and two of them meet at an angle of more than
/// kLeastKink.
bool is_kinked(const Path& path);

/// Whether a band may fold over itself, as it does where its path is too tight or has kinks.
enum class Folds : std::uint8_t { kNever, kPerhaps };

/// Appends the polygon of a ring of worked land. Where the ring folds over itself, all that it encloses
/// counts.
void append_ground(Ring ring, Folds folds, Region& out);

/// The band of every segment, one after the other; bands touch, and overlap where the path comes back. At
/// kinks of straight segments they are cut or lengthened to the kink's bisector, so that each has the area
/// width · length; kinks of more than 120°, and those beside a segment whose bisectors meet within its band,
/// have flat ends.
Region bands_along(const Path& path, double width_m, double sagitta_m = kChordSagitta);

/// The same with flat ends of every segment, even at kinks: the bands by which drivable headland passes are
/// counted.
Region flat_bands_along(const Path& path, double width_m, double sagitta_m = kChordSagitta);

/// The bands by which a pass is counted: with flat ends, and of a plain headland
/// (HeadlandConstruction::kPlain) as bands_along().
Region pass_bands_along(const Path& path, HeadlandConstruction how, double width_m,
                        double sagitta_m = kChordSagitta);

/// The path without its first `by_m`; empty where nothing remains.
Path begun_later(const Path& path, double by_m);

/// The path without its first and last `by_m`; empty where nothing remains.
Path shortened(const Path& path, double by_m);

/// The point at a distance from the beginning of a segment, and the heading there (a unit vector).
Point point_on(const PathSegment& segment, double along_m);
Point heading_on(const PathSegment& segment, double along_m);

/// The point `along_m` from the beginning of a path, or its end where the path is shorter.
Point point_on(const Path& path, double along_m);

/// Length of all arcs, m.
double arcs_m(const Path& path);

}  // namespace tramline::check
