#pragma once
// Lines of a log that give the state of work, where its records do not.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tramline/io/fixes/boom_list.h"
#include "tramline/io/log/section_text.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// The columns that a log has itself: lines are ignored for these.
struct OwnColumns {
  bool work = false;  ///< or sections
  bool width = false;
};

/// `#work=1`, `#sections=1101` (from left to right) and `#width=3|4.5|3` (metres; of the machine, or of each
/// section from left to right). Each applies to the fixes after it until the next of its kind; an empty value
/// revokes it. With `#!` instead of `#` it comes from the user of `watch`. Before the first line on work the
/// machine works: see work_before().
class StateLines {
 public:
  /// Whether this is such a line. One whose value is not understood changes nothing and is put into
  /// `skipped`.
  bool add(std::string_view line, std::size_t record, SkippedRecords& skipped);
  /// Applies the lines so far to the next fix. `booms`: those of its log.
  void apply(Fix& fix, BoomList& booms, OwnColumns own) const;
  /// Number of the first line on work; 0: none.
  std::size_t first_record() const { return first_record_; }

 private:
  WorkState work_ = WorkState::kUnknown;
  std::optional<SectionText> sections_;
  std::vector<double> widths_m_;
  std::size_t first_record_ = 0;
};

/// The line by which the user of `watch` switches work: "#!work=1".
std::string work_line(bool works);

/// Sets fixes before the first line on work to at work, unless they have a state of their own. O(fixes).
void work_before(WorkLog& log, const StateLines& lines);

}  // namespace tramline::io
