#include "tramline/io/log/state_lines.h"

#include "tramline/io/fixes/number_text.h"
#include "tramline/io/log/work_word.h"

namespace tramline::io {
namespace {

/// What follows the key, if the line is "#key…" or, from the program itself, "#!key…".
std::optional<std::string_view> value_of(std::string_view line, std::string_view key) {
  if (!line.starts_with('#')) return std::nullopt;
  line.remove_prefix(line.starts_with("#!") ? 2 : 1);
  if (!line.starts_with(key)) return std::nullopt;
  return trimmed(line.substr(key.size()));
}

std::optional<std::vector<double>> widths_in(std::string_view text) {
  std::vector<double> out;
  while (!text.empty()) {
    const std::size_t bar = text.find('|');
    const std::optional<double> width_m = number_in(trimmed(text.substr(0, bar)));
    if (!width_m || !(*width_m >= 0 && *width_m <= kWidestMachine_m) || out.size() == kMostSections)
      return std::nullopt;
    out.push_back(*width_m);
    text = bar == std::string_view::npos ? std::string_view() : text.substr(bar + 1);
  }
  return out;
}

}  // namespace

bool StateLines::add(std::string_view line, std::size_t record, SkippedRecords& skipped) {
  line = trimmed(line);
  const auto told = [&] {
    if (first_record_ == 0) first_record_ = record;
    return true;
  };
  if (const auto work = value_of(line, "work=")) {
    const std::optional<WorkState> state = work_word(*work);
    if (!state) {
      skipped.add(record, "work is neither 1 nor 0");
      return true;
    }
    work_ = *state;
    return told();
  }
  if (const auto sections = value_of(line, "sections=")) {
    const std::optional<SectionText> text = section_signs(*sections, SectionOrder::kFromLeft);
    if (!text && !sections->empty()) {
      skipped.add(record, "the states of sections are not understood");
      return true;
    }
    sections_ = text && text->known && text->count > 0 ? text : std::nullopt;
    return told();
  }
  if (const auto width = value_of(line, "width=")) {
    if (const auto widths_m = widths_in(*width))
      widths_m_ = *widths_m;
    else
      skipped.add(record, "the width is not understood");
    return true;
  }
  return false;
}

void StateLines::apply(Fix& fix, BoomList& booms, OwnColumns own) const {
  std::vector<double> widths_m = own.width ? std::vector<double>{} : widths_m_;
  if (!own.work) {
    fix.work = work_;
    if (sections_) {
      // One width for all sections: equal shares of it.
      if (widths_m.size() == 1 && sections_->count > 1)
        widths_m.assign(sections_->count, widths_m.front() / static_cast<double>(sections_->count));
      if (widths_m.size() > 1 || (widths_m.size() == 1 && sections_->count == 1)) {
        fix.has_sections = true;
        fix.sections = sections_->states;
      }
      if (fix.work == WorkState::kUnknown)
        fix.work = sections_->states.any() ? WorkState::kOn : WorkState::kOff;
    }
  }
  if (!widths_m.empty()) fix.boom = booms.number_of(side_by_side(widths_m));
}

std::string work_line(bool works) { return works ? "#!work=1" : "#!work=0"; }

void work_before(WorkLog& log, const StateLines& lines) {
  if (lines.first_record() == 0) return;
  for (Fix& fix : log.fixes) {
    if (fix.record >= lines.first_record()) break;
    if (fix.work == WorkState::kUnknown && !fix.has_sections) fix.work = WorkState::kOn;
  }
}

}  // namespace tramline::io
