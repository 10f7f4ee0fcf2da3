#pragma once
// What a machine that steers and changes gear drives: stretches on which the curvature is constant or changes
// evenly, forward or in reverse.

#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/geometry/path/path.h"
#include "tramline/geometry/point.h"

namespace tramline {

/// Where a machine is and where it points: the middle of its rear axle, metres.
struct Pose {
  Point at;
  Heading heading;
};

enum class Gear { kForward, kReverse };
const char* name(Gear gear);  ///< forward, reverse

/// A stretch without change of gear. The curvature runs evenly from one value to the other: equal values are
/// a line or an arc, of any angle, others a clothoid. In reverse the machine moves against its heading, along
/// the same circle.
struct SteeredStretch {
  Pose start;
  double length_m = 0;            ///< ≥ 0, also in reverse
  double curvature_at_start = 0;  ///< 1/m; positive: the centre of the circle is on the machine's left
  double curvature_at_end = 0;
  Gear gear = Gear::kForward;

  bool clothoid() const { return curvature_at_start != curvature_at_end; }
};

/// Stretches one after the other: each begins in the pose in which the last one ended. May be empty.
using SteeredPath = std::vector<SteeredStretch>;

/// The pose after the given length of the stretch, m; 0 ≤ `after_m` ≤ length_m. Lines and arcs in closed
/// form, clothoids by quadrature to 1e-12 of their length.
Pose pose_after(const SteeredStretch& stretch, double after_m);
Pose end_of(const SteeredStretch& stretch);

double length(const SteeredPath& path);
int gear_changes(const SteeredPath& path);

/// The stretch from a pose with constant curvature.
SteeredStretch arc_from(const Pose& start, double length_m, double curvature, Gear gear);

/// The same path driven the other way: back in the other gear, the machine pointing as before.
SteeredPath retraced(const SteeredPath& path);
/// The path of a machine that points the other way and drives from the end to the start in the same gears.
SteeredPath turned_round(const SteeredPath& path);
/// The mirror image in the axis through `at` along `heading`.
SteeredPath mirrored(const SteeredPath& path, const Pose& axis);

/// Lines and arcs of at most half a circle that the middle of the axle follows; clothoids as chords that
/// deviate by at most `sagitta_m`. Stretches without length are left out.
Path trace(const SteeredPath& path, double sagitta_m = kChordSagitta);

}  // namespace tramline
