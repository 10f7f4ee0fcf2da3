#include "tramline/coverage/drive/driven_lines.h"

#include <algorithm>
#include <iterator>

namespace tramline::coverage {

void DrivenLines::add(const Fix& fix, Point at, Continuity continuity,
                      const std::optional<WorkedStep>& step) {
  const int run = step ? step->run : -1;
  const auto [entry, first] = units_.try_emplace(fix.unit);
  Unit& unit = entry->second;
  if (first || continuity == Continuity::kBroken) {
    unit.line = lines_.size();
    lines_.push_back({run, {at}, fix.time_s, fix.time_s});
  } else {
    DrivenLine* line = &lines_[unit.line];
    if (line->line.size() == 1) {
      line->run = run;
    } else if (line->run != run) {
      unit.line = lines_.size();
      lines_.push_back({run, {unit.last}, unit.last_s, unit.last_s});
      line = &lines_.back();
    }
    line->line.push_back(at);
    line->to_s = fix.time_s;
  }
  unit.last = at;
  unit.last_s = fix.time_s;
}

std::vector<DrivenLine> DrivenLines::lines() const {
  std::vector<DrivenLine> out;
  std::copy_if(lines_.begin(), lines_.end(), std::back_inserter(out),
               [](const DrivenLine& line) { return line.line.size() > 1; });
  return out;
}

}  // namespace tramline::coverage
