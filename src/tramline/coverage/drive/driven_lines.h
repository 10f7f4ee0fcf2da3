#pragma once
// The lines of a drive, for pictures and files.

#include <map>
#include <optional>
#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/model/coverage.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// Joins the positions of the implement to lines. A new line begins where a run of work begins or ends, and
/// where fixes are not joined.
class DrivenLines {
 public:
  /// Adds the next fix with the position of the implement, whether it is joined to the previous fix, and the
  /// step that ended there, if any.
  void add(const Fix& fix, Point position, Continuity continuity, const std::optional<WorkedStep>& step);
  /// All lines, in the order of their beginnings.
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
