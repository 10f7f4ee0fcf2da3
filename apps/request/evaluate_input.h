#pragma once
// A log and the field it was driven on, in one frame.

#include <optional>
#include <string>

#include "request/field_input.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/field.h"
#include "tramline/model/plan.h"
#include "tramline/model/work_log.h"

namespace tramline::app {

/// A log without a fix nearer to the field than this was driven elsewhere, m.
inline constexpr double kNear_m = 2000;

/// The land to work. Frame: local metres.
struct WorkGround {
  std::string field_id;  ///< empty: no field
  Region ground;         ///< the field less its obstacles, passable ones too; empty: no field
  LocalFrame frame;
};

/// The field of --field, all parts of the feature chosen; nullopt where none was given. Throws kBadInput.
std::optional<WorkGround> work_ground(const FieldOptions& options);
/// The field a plan was made for: all of it, headlands included.
WorkGround work_ground(const Plan& plan);

/// Shapes in another frame, both geodetic or both plain. Throws kBadInput where the two lie too far apart.
Region moved(Region region, const LocalFrame& from, const LocalFrame& to);

/// The steps of a plan's pieces and headland passes in another frame.
coverage::FurtherWork work_of(const Plan& plan, const LocalFrame& frame);

/// The log in the frame of `ground` or, without a field, in a frame of its own, which `ground` then receives.
/// Throws kBadInput where no fix lies near the field, with a hint where longitude and latitude seem to be
/// swapped.
WorkLog placed_on(WorkLog log, WorkGround& ground);

}  // namespace tramline::app
