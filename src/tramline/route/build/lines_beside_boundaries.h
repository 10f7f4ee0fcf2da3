#pragma once
// Lines along which a machine may drive beside boundaries that have no headland pass.

#include <list>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "tramline/headland/headland.h"
#include "tramline/model/plan.h"
#include "tramline/route/connection/driving_ground.h"
#include "tramline/route/connection/roadmap.h"

namespace tramline {

/// Lines round the field and round obstacles that have no passes, as near to them as the outline may be while
/// it turns. They may leave the land. As long as a headland of one pass takes.
std::vector<FollowedLine> lines_beside_boundaries(const Headland& headland, const Field& field,
                                                  const DrivingGround& ground);

/// These lines, found by the first route that needs them, for all routes behind the same headland, also with
/// its corners worked out: some need none, and finding them takes as long as a route. For any number of
/// threads.
class LinesBesideBoundaries {
 public:
  /// Those of a headland, which stay where they are. Precondition: field and machine are those of the first
  /// call.
  const std::vector<FollowedLine>& found(const Headland& headland, const Field& field,
                                         const DrivingGround& ground) const;

 private:
  mutable std::mutex taken_{};
  /// By terms of passes along them: passes of one headland go round its boundaries or, with corners worked
  /// out, no longer do.
  mutable std::list<std::pair<HeadlandTerms, std::vector<FollowedLine>>> by_terms_{};
};

/// The lines round all boundaries, passes or not, for machines that are narrower than in fact: found by the
/// first route that needs them, for all routes of a field and machine. For any number of threads.
class LinesForNarrower {
 public:
  /// Precondition: the field is that of the first call, and machines of one width differ in nothing.
  const std::vector<FollowedLine>& round_all(const Field& field, const DrivingGround& narrowed) const;

 private:
  mutable std::mutex taken_{};
  mutable std::map<double, std::vector<FollowedLine>> by_width_m_{};
};

}  // namespace tramline
