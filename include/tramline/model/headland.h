#pragma once
// Passes round a field and its obstacles, and the ground they are there for (S2.4).

#include <cstddef>
#include <vector>

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// Closed: it ends where it begins, in the direction it began in. The land that it goes round, or that is
/// left for further passes, lies on its left: round the field it runs counter-clockwise, round an obstacle
/// clockwise. Or open: from one end to the other, with the boundary that it follows on its right.
struct HeadlandPass {
  Path path;
  int number = 1;             ///< 1 is the outermost, next to the boundary
  bool around_field = false;  ///< follows the field's boundary somewhere
  /// Indices into Field::obstacles: those it goes round or follows, increasing.
  std::vector<std::size_t> obstacles;

  friend bool operator==(const HeadlandPass& a, const HeadlandPass& b) = default;
};

/// Frame: the field's local metres. field = ground ∪ body ∪ obstacles, which do not overlap.
struct Headland {
  std::vector<HeadlandPass> passes;  ///< by number
  std::vector<int> obstacle_passes;  ///< how many each obstacle has, by Field::obstacles; 0, also where the
                                     ///< list ends early: no headland
  Region ground;  ///< what the passes are there to work: nearer to a boundary than its passes are wide, but
                  ///< for what none of them works and tracks can
  double worked_m2 = 0;     ///< Σ width · length of the passes, without what lies on passable obstacles,
                            ///< where the work is interrupted
  double overlap_m2 = 0;    ///< worked outside `ground`, or worked there again
  double uncovered_m2 = 0;  ///< of `ground`: worked_m2 = area(ground) − uncovered_m2 + overlap_m2
  Region unworked;          ///< `uncovered_m2` as a picture
};

/// Does the pass end where it begins?
bool is_closed(const HeadlandPass& pass);

/// The ground that a pass works: a ring where it is closed, with flat ends where it is open. Chords stand for
/// arcs (`sagitta_m`).
/// Precondition: the swath does not meet itself.
Polygon swath(const HeadlandPass& pass, double width_m, double sagitta_m);

/// Length of all passes, m.
double length(const Headland& headland);

}  // namespace tramline
