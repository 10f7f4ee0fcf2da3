#pragma once
// Where a machine may turn, and how far it leaves that land.

#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/check/turning/driven_machine.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// How far something is off the land.
struct Excursion {
  double depth_m = 0;  ///< 0: it stays on the land
  Point at;
};

/// Whether a machine may be on passable obstacles: it crosses them, but does not turn on them.
enum class Passables { kAreObstacles, kAreLand };
/// Whether all land outside the field may be used, or only what turns may use.
enum class Beyond { kAsForTurns, kIsLand };

/// How far beyond the boundary is land to turn on, m; nullopt: everywhere.
std::optional<double> land_beyond_m(const Plan& plan);

/// The field without its obstacles, passable ones included unless they are land; where the boundary is soft
/// and has no headland, also the land outside, as far as the settings allow: where headlands follow the
/// turns, as far as room beyond is given.
class TurningGround {
 public:
  explicit TurningGround(const Plan& plan, Passables passables = Passables::kAreObstacles,
                         Beyond beyond = Beyond::kAsForTurns);

  /// The deepest excursion of the outline at places at most `step_m` apart along the path. The drawbar of a
  /// towed implement is in line where the path begins. Places far from all edges are not gone through one by
  /// one.
  Excursion deepest(const SteeredPath& path, const Machine& machine, double step_m) const;

 private:
  struct BoundedRing {
    Ring ring;
    Box box;
    bool field = false;  ///< the land is inside; else outside
  };
  using Outline = std::vector<Side>;
  bool clear_of_edges(const SteeredStretch& stretch, double outline_m) const;
  void measure(const std::vector<MachinePlace>& places, const Machine& machine, Excursion& deepest) const;
  void measure(const BoundedRing& ring, const std::vector<Outline>& outlines, const Box& reach,
               Excursion& deepest) const;
  void measure(const BoundedRing& ring, const std::vector<Side>& near_edges, const Side& side,
               Excursion& deepest) const;

  std::vector<BoundedRing> rings_;
  double beyond_m_ = 0;  ///< of the field's ring, that is land as well
};

}  // namespace tramline::check
