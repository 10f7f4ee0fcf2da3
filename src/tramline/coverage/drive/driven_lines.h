#pragma once
// The drive as lines, for pictures and files.

#include <map>
#include <optional>
#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/model/coverage.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// Collects the places of the implement to lines: a new one wherever a run of work begins or ends, and where
/// fixes are not joined.
class DrivenLines {
 public:
  /// The next fix, where it found the implement, whether the drive went on to it, and the step that ended
  /// there, if any.
  void add(const Fix& fix, Point place, Continuity continuity, const std::optional<WorkedStep>& step);
  /// All lines, in the order they began in.
  std::vector<DrivenLine> lines() const;

 private:
  struct Unit {
    std::size_t line = 0;
    Point last;
    double last_s = 0;
  };
  std::vector<DrivenLine> lines_;
  std::map<int, Unit> units_;
};

}  // namespace tramline::coverage
