#pragma once
// Lines of a log that say whether the machine works, where its records do not.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tramline/io/fixes/boom_list.h"
#include "tramline/io/log/section_text.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// Which of its own columns a log has: lines say nothing there.
struct OwnColumns {
  bool work = false;  ///< or sections
  bool width = false;
};

/// `#work=1`, `#sections=1101` (from left to right) and `#width=3|4.5|3` (metres; of the machine, or of each
/// section from left to right). Each holds for the fixes after it until the next of its kind; an empty value
/// takes it back. With `#!` for `#` it is the watcher who said so. Before the first one that tells of work
/// the machine works: see work_before().
class StateLines {
 public:
  /// Whether this is such a line. One whose value is not understood changes nothing and is put into
  /// `skipped`.
  bool add(std::string_view line, std::size_t record, SkippedRecords& skipped);
  /// What was said, for a fix that comes now. `booms`: of its log.
  void apply(Fix& fix, BoomList& booms, OwnColumns own) const;
  /// Number of the first line that told of work; 0: none.
  std::size_t first_record() const { return first_record_; }

 private:
  WorkState work_ = WorkState::kUnknown;
  std::optional<SectionText> sections_;
  std::vector<double> widths_m_;
  std::size_t first_record_ = 0;
};

/// The line by which a watcher says so: "#!work=1".
std::string work_line(bool works);

/// Fixes before the first line that told of work were at work, unless they tell otherwise. O(fixes).
void work_before(WorkLog& log, const StateLines& lines);

}  // namespace tramline::io
