#pragma once
// The land that one part of the outline sweeps in an even motion, and what meets it.

#include <array>
#include <cstddef>

#include "tramline/turns/outline/even_motion.h"

namespace tramline {

/// Coordinates are those of the part's frame at the start of the motion (to_part()). There the motion is a
/// flow, x' = v − ω y, y' = ω x for a unit of time, and f = ½ω(x² + y²) − v y is constant along its paths,
/// lines and arcs alike: with it neither the centre of a wide arc nor its radius is needed.
class PartSweep {
 public:
  PartSweep(const Box& part, const EvenMotion& motion);

  /// Whether the edge from a to b meets the part at its start, a corner of the part drives across the edge,
  /// or the part over the edge's first end. With all edges of a closed ring that is whether the part meets
  /// the ring at any time: what a convex part meets first is met by a corner of it, or is a corner itself. No
  /// tolerance: rounding, about 1e-10 m, decides what just touches. O(1).
  bool meets(Point a, Point b) const;

 private:
  /// A point's path through the motion, or back through it.
  struct Way {
    Point from;
    Point chord;     ///< to where the path ends
    double level;    ///< f
    double speed_2;  ///< square of the length driven
    double side;     ///< +1: anticlockwise, so the path lies on the right of its chord; −1: clockwise
  };
  Way way(Point p, double side) const;
  double level(Point p) const { return 0.5 * turn_ * dot(p, p) - way_ * p.y; }
  bool meets_box(Point a, Point b) const;
  bool levels_meet(Point a, Point along) const;
  bool crosses(const Way& way, Point a, Point along) const;
  bool passes(const Way& way, Point on_circle) const;

  // The motion turns left: where it turns right, everything is mirrored.
  bool mirrored_;
  double way_;
  double turn_;
  Box part_;
  Box swept_;  ///< of a motion that does not turn
  Point moved_;
  double cos_;
  double sin_;
  std::size_t corners_ = 0;
  std::array<Way, 4> corner_ways_{};
  double lowest_ = 0;  ///< least and greatest f on the part
  double highest_ = 0;
};

}  // namespace tramline
