#pragma once
// What a machine and its implement take up of the ground.

#include <array>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/machine.h"

namespace tramline {

/// Parts are boxes in a frame of their own: x ahead, y to the left, metres. A box may be a line.
struct Outline {
  std::vector<Box> on_machine;    ///< from the middle of the machine's rear axle
  std::vector<Box> on_implement;  ///< from the middle of a towed implement's axle, along its drawbar
  double hitch_m = 0;             ///< from the machine's axle back to the hitch; negative: in front of it
  double drawbar_m = 0;           ///< from the hitch to the implement's axle; 0: nothing is towed

  bool tows() const { return drawbar_m > 0; }
};

/// The vehicle, from the axle to its front; and the implement: a bar of the working width, as deep as
/// rear_overhang_m. On the machine where it is mounted, or towed without a drawbar; on the implement,
/// together with the drawbar, where it is towed. Without further word a bar at the axle. A vehicle without
/// length and width is left out. Precondition: width_m > 0, front_overhang_m and rear_overhang_m ≥ 0.
Outline outline_of(const Machine& machine);

/// Corners of a part, anticlockwise from the rear right; two or four of them are equal where it is a line or
/// a point.
std::array<Point, 4> corners_of(const Box& part);
/// Distance of the farthest corner from the origin of the part's frame, m.
double farthest_corner_m(const Box& part);
/// How far the parts reach to a side at most while machine and implement go straight on, m.
double half_breadth_m(const Outline& outline);

/// Where the frame of a part is: its origin and the unit vector ahead.
struct Placement {
  Point at;
  Point ahead;
};

inline Placement placed(const Pose& pose) { return {pose.at, pose.heading.unit()}; }

inline Point to_ground(const Placement& frame, Point of_part) {
  return frame.at + of_part.x * frame.ahead + of_part.y * left_of(frame.ahead);
}
inline Point to_part(const Placement& frame, Point on_ground) {
  const Point from_origin = on_ground - frame.at;
  return {dot(frame.ahead, from_origin), cross(frame.ahead, from_origin)};
}

}  // namespace tramline
