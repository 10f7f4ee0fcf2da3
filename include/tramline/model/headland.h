#pragma once
// Headlands: passes round a field and its obstacles, and the land they are meant to work (Zhou §2.3.3).

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// How passes are made. kDrivable: lines and arcs that the machine can follow. kPlain: as in Zhou §2.3.3,
/// offsets of the boundaries with all corners, for comparison.
enum class HeadlandConstruction { kDrivable, kPlain };

/// One headland pass. A closed pass ends where it begins, in the direction it began in; the land that it goes
/// round, or that remains for further passes, lies on its left: round the field it runs counter-clockwise,
/// round an obstacle clockwise. An open pass runs from one end to the other, with the boundary that it
/// follows on its right.
struct HeadlandPass {
  Path path;
  int number = 1;             ///< 1 is the outermost, next to the boundary
  bool around_field = false;  ///< follows the field's boundary somewhere
  /// Indices into Field::obstacles of those it goes round or follows, ascending.
  std::vector<std::size_t> obstacles;

  friend bool operator==(const HeadlandPass& a, const HeadlandPass& b) = default;
};

/// Passes along one boundary: those round the field, or those that go round a common obstacle.
bool along_one_boundary(const HeadlandPass& a, const HeadlandPass& b);

/// Frame: the field's local metres. field = ground ∪ body ∪ obstacles, which do not overlap.
struct Headland {
  std::vector<HeadlandPass> passes;  ///< by number
  HeadlandConstruction construction = HeadlandConstruction::kDrivable;
  std::vector<int> obstacle_passes;  ///< number of passes by index into Field::obstacles; 0, or beyond the
                                     ///< end of the list: no headland
  Region ground;  ///< the land the passes are meant to work: all land nearer to a boundary than its passes
                  ///< are wide, except land that no pass works but tracks can
  double worked_m2 = 0;     ///< Σ width · length of the passes, without what lies on passable obstacles,
                            ///< where the work is interrupted
  double overlap_m2 = 0;    ///< worked outside `ground`, or worked there again
  double uncovered_m2 = 0;  ///< of `ground`: worked_m2 = area(ground) − uncovered_m2 + overlap_m2
  Region unworked;          ///< the land of uncovered_m2, as polygons for display
  /// Number of passes by edge of Field::outer, where they differ; empty: as many round the whole field.
  std::vector<int> edge_passes{};
};

const char* name(HeadlandConstruction how);  ///< drivable, plain
/// The inverse of name(); nullopt for any other word.
std::optional<HeadlandConstruction> headland_construction_named(std::string_view word);

/// Whether the pass ends where it begins.
bool is_closed(const HeadlandPass& pass);

/// The land that a pass works: a ring for a closed pass, a band with flat ends for an open one. Arcs become
/// chords (`sagitta_m`). At kinks its sides meet in mitres. Precondition: the swath does not touch itself.
Polygon swath(const HeadlandPass& pass, double width_m, double sagitta_m);

/// Of numbers of passes by edge, the least and the largest; 0 where there are none.
int passes_everywhere(const std::vector<int>& edge_passes);
int passes_anywhere(const std::vector<int>& edge_passes);

/// Length of all passes, m.
double length(const Headland& headland);

}  // namespace tramline
