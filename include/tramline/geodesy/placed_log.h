#pragma once
// Logs with positions in the metres of a field's frame.

#include <optional>
#include <string>

#include "tramline/geodesy/field_projection.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/local_frame.h"
#include "tramline/model/work_log.h"

namespace tramline {

/// The bounding box of the log's positions in its own coordinates, without positions that are not on the
/// globe.
Box bounds(const WorkLog& log);

/// The frame for a log without a field: centred on the middle of its positions. Throws kBadInput for a log
/// without a usable position.
LocalFrame frame_centred_on(const WorkLog& log);

/// Converts positions of a log to the metres of a frame, one by one. Owns a PROJ context.
class FixPlacing {
 public:
  /// `name`: of the log, for messages. Throws kBadInput for plain metres with a geodetic frame and the
  /// reverse.
  FixPlacing(Positions positions, const LocalFrame& frame, const std::string& name);

  /// The local position; nullopt, with the reason in `why`, for a position that is not a valid one or lies
  /// outside the frame.
  std::optional<Point> operator()(Point position, std::string& why) const;

 private:
  Positions positions_;
  LocalFrame frame_;
  std::optional<FrameProjection> projection_;
};

/// Whether any fix of the log lies within `within_m` of a box of the frame. Throws like placed(). O(n) at
/// most.
bool comes_near(const WorkLog& log, const LocalFrame& frame, const Box& local, double within_m);

/// The log with local positions. Fixes without a position in the frame (not a number, past a pole, too far
/// away) are skipped, and listed by their record. A log in plain metres has to come with a plain frame, and
/// one in degrees with a geodetic one: throws kBadInput otherwise. O(n).
WorkLog placed(WorkLog log, const LocalFrame& frame);

}  // namespace tramline
