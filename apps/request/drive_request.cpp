#include "request/drive_request.h"

namespace tramline::app {

void apply(const DriveOptions& options, coverage::EvaluateSettings& settings) {
  settings.drive = options.drive;
  settings.drive.quads =
      options.quads == "segment" ? coverage::QuadShape::kSegment : coverage::QuadShape::kHeading;
  settings.drive.switching =
      options.switching == "step" ? coverage::Switching::kStep : coverage::Switching::kInterpolate;
  settings.repeat = options.repeat == "strict" ? coverage::RepeatRule::kStrict : coverage::RepeatRule::kRun;
}

}  // namespace tramline::app
