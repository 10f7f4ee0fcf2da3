#pragma once
// Which leg of a route is the first to work a place.

#include <cstddef>
#include <limits>
#include <vector>

#include "tramline/geometry/index/box_grid.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// The land that pieces and passes work, by the legs that begin them. Legs that name
/// none of the plan work nothing.
class WorkedGround {
 public:
  explicit WorkedGround(const Plan& plan);

  static constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();
  /// By index of the leg: of the land as it is, less a margin, and with it. Where these differ it is not for
  /// certain.
  struct First {
    std::size_t surely = kNever;
    std::size_t perhaps = kNever;
  };
  First first_at(Point p) const;

 private:
  struct Strip {
    PathSegment segment;
    std::size_t leg = 0;
    double unsure_before_m = 0;  ///< how far its ends may be elsewhere, where it begins or ends the work
    double unsure_behind_m = 0;
  };
  void add(const Path& path, std::size_t leg, double unsure_m);

  double half_m_;
  std::vector<Strip> strips_;
  BoxGrid grid_;
};

/// Worked land is drawn to this, m.
inline constexpr double kWorkedMargin_m = 0.02;

}  // namespace tramline::check
