#include "request/drive_request.h"

namespace tramline::app {
namespace {

coverage::HeadingReading reading_of(const std::string& word) {
  for (const auto reading : {coverage::HeadingReading::kMath, coverage::HeadingReading::kFromTrack})
    if (word == name(reading)) return reading;
  return coverage::HeadingReading::kCompass;
}

}  // namespace

void apply(const DriveOptions& options, coverage::EvaluateSettings& settings) {
  settings.drive = options.drive;
  settings.drive.quads =
      options.quads == "segment" ? coverage::QuadShape::kSegment : coverage::QuadShape::kHeading;
  settings.drive.switching =
      options.switching == "step" ? coverage::Switching::kStep : coverage::Switching::kInterpolate;
  settings.drive.headings = reading_of(options.headings);
  settings.engine = options.engine == "mesh" ? coverage::EngineKind::kMesh : coverage::EngineKind::kExact;
  settings.mesh_m = options.mesh_m;
  settings.repeat = options.repeat == "strict" ? coverage::RepeatRule::kStrict : coverage::RepeatRule::kRun;
}

}  // namespace tramline::app
