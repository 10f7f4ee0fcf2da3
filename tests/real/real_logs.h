#pragma once
// Real logs as test material.

#include <string>
#include <vector>

#include "real/real_fields.h"
#include "tramline/coverage/drive/step_maker.h"
#include "tramline/model/field.h"
#include "tramline/model/work_log.h"

namespace tramline::testing {

/// Names of the files in the folder of logs, sorted.
std::vector<std::string> real_logs();
/// A log of that folder, its positions as in the file.
WorkLog real_log_as_read(const std::string& name);
/// A log of that folder in the frame, or in one of its own.
WorkLog real_log(const std::string& name, const LocalFrame& frame);
WorkLog real_log(const std::string& name);

/// Precondition: there is one, of one part.
Field field_named(const RealFields& fields, const std::string& id);
/// Less its obstacles, oriented.
Region ground_of(const Field& field);

/// How far the areas and the regions of the stream are from the union of all quads at once, as shares of the
/// worked area: covered, covered inside, missed, worked twice or more.
struct BatchDifference {
  double areas = 0;
  double regions = 0;
};
BatchDifference stream_against_batch(const WorkLog& log, const Region& field,
                                     const coverage::DriveSettings& settings);

}  // namespace tramline::testing
