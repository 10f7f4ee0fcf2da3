#include "tramline/io/log/fix_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tramline/io/fixes/course_heading.h"
#include "tramline/io/fixes/number_text.h"
#include "tramline/io/log/section_text.h"
#include "tramline/io/log/work_word.h"

namespace tramline::io {
namespace {

// Rows that differ in one of them are of different units.
constexpr std::array kUnitColumns = {LogColumn::kMachine, LogColumn::kSection, LogColumn::kUnit,
                                     LogColumn::kPass};

double time_factor(const ColumnMap& map) {
  const auto& time = map[LogColumn::kTime];
  return time && time->unit_named ? time->factor : 0;
}

}  // namespace

FixRows::FixRows(std::span<const std::string> names, TableForm form)
    : form_(std::move(form)),
      map_(map_columns(names, form_.columns, form_.positions, form_.place)),
      names_(names.begin(), names.end()),
      time_(time_factor(map_)) {}

std::string_view FixRows::cell(LogColumn column) const {
  const auto& use = map_[column];
  return !use || use->index >= cells_.size() ? std::string_view() : trimmed(cells_[use->index]);
}

std::optional<double> FixRows::number_of(std::string_view text) const {
  if (!form_.decimal_comma || text.find(',') == std::string_view::npos) return number_in(text);
  if (text.find('.') != std::string_view::npos) return std::nullopt;
  std::string with_point(text);
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  return number_in(with_point);
}

std::optional<double> FixRows::number(LogColumn column) const {
  const auto value = number_of(cell(column));
  return value ? std::optional(*value * map_[column]->factor) : std::nullopt;
}

std::optional<Point> FixRows::position() const {
  const auto x = number(LogColumn::kLon), y = number(LogColumn::kLat);
  return x && y ? std::optional(Point{*x, *y}) : std::nullopt;
}

/// nullopt: the row does not say how wide the machine works.
std::optional<FixRows::Widths> FixRows::widths() {
  std::string_view text = cell(LogColumn::kWidth);
  if (text.empty()) return std::nullopt;
  const double factor = map_[LogColumn::kWidth]->factor;
  Widths out;
  bool any = false;
  for (bool more = true; more;) {
    const std::size_t bar = text.find('|');
    const std::string_view part = trimmed(text.substr(0, bar));
    const auto value = number_of(part);
    any = any || value.has_value();
    const double width_m = value ? *value * factor : 0;
    if ((!part.empty() && !value) || width_m < 0 || width_m > kWidestMachine_m ||
        out.size() == kMostSections) {
      ++bad_widths_;
      return std::nullopt;
    }
    out.push_back(width_m);
    more = bar != std::string_view::npos;
    if (more) text = text.substr(bar + 1);
  }
  return any ? std::optional(out) : std::nullopt;
}

void FixRows::set_motion(Fix& fix) const {
  fix.speed_mps = number(LogColumn::kSpeed).value_or(fix.speed_mps);
  if (const auto heading = number(LogColumn::kHeading))
    fix.heading = heading_of_degrees(*heading);
  else if (const auto course = number(LogColumn::kCourse))
    fix.heading = heading_of_course(*course, fix.speed_mps);
}

void FixRows::set_work(Fix& fix) {
  const std::optional<WorkState> work = work_word(cell(LogColumn::kWork));
  if (!work) ++bad_work_;
  fix.work = work.value_or(WorkState::kUnknown);
}

void FixRows::set_rate(Fix& fix) {
  if (cell(LogColumn::kRate).empty()) return;
  const auto rate = number(LogColumn::kRate);
  if (rate && *rate >= 0 && std::isfinite(*rate))
    fix.rate_per_ha = *rate;
  else
    ++bad_rates_;
}

void FixRows::set_sections(Fix& fix, std::optional<Widths> widths) {
  std::optional<SectionText> text;
  bool written = false;
  for (const LogColumn column :
       {LogColumn::kSections, LogColumn::kSectionsFromRight, LogColumn::kCondensed}) {
    if (text || cell(column).empty()) continue;
    written = true;
    const SectionOrder order =
        column == LogColumn::kSectionsFromRight ? SectionOrder::kFromRight : SectionOrder::kFromLeft;
    text = column == LogColumn::kCondensed ? condensed_sections(cell(column))
                                           : section_signs(cell(column), order);
  }
  if (written && !text) ++bad_sections_;
  if (text && text->known) {
    // One width for all sections: equal shares of it.
    if (widths && widths->size() == 1 && text->count > 1)
      widths = Widths(text->count, widths->front() / static_cast<double>(text->count));
    const bool placed = widths && (widths->size() > 1 || text->count == 1);
    if (placed) {
      fix.has_sections = true;
      fix.sections = text->states;
    } else {
      ++sections_without_width_;
    }
    if (fix.work == WorkState::kUnknown) fix.work = text->states.any() ? WorkState::kOn : WorkState::kOff;
  }
  if (widths) fix.boom = booms_.number_of(side_by_side(*widths));
}

int FixRows::unit_of_row() {
  std::string key;
  for (const LogColumn column : kUnitColumns) {
    key += cell(column);
    key += '\n';
  }
  const auto at = units_.find(key);
  if (at != units_.end()) return at->second;
  return units_.emplace(std::move(key), static_cast<int>(units_.size())).first->second;
}

std::optional<Fix> FixRows::add(std::span<const std::string_view> cells, std::size_t record,
                                std::optional<Point> elsewhere) {
  cells_ = cells;
  const auto at = elsewhere ? elsewhere : position();
  if (!at) {
    skipped_.add(record, "no position");
    return std::nullopt;
  }
  Fix fix;
  fix.record = record;
  fix.position = *at;
  fix.time_s = time_.time_s(cell(LogColumn::kTime), cell(LogColumn::kDate));
  if (std::isnan(fix.time_s) && !cell(LogColumn::kTime).empty()) ++bad_times_;
  set_motion(fix);
  set_work(fix);
  set_rate(fix);
  set_sections(fix, widths());
  fix.unit = unit_of_row();
  if (const auto counted = number(LogColumn::kCounterArea))
    areas_[std::string(cell(LogColumn::kMachine))].add(*counted);
  last_distance_ = number(LogColumn::kDistance).value_or(std::numeric_limits<double>::quiet_NaN());
  return fix;
}

MachineCounters FixRows::counters() const {
  MachineCounters out;
  for (const auto& [machine, area] : areas_) {
    if (!(area.total() > 0)) continue;  // the area of the field, and no counter
    MachineCounters of_machine;
    of_machine.area_m2 = area.total();
    out.add(of_machine);
  }
  return out;
}

bool FixRows::width_unit_open() const {
  const auto& width = map_[LogColumn::kWidth];
  return width && !width->unit_named;
}

std::vector<std::string> FixRows::notes() const {
  std::vector<std::string> out;
  const auto named = [&](LogColumn column) {
    const auto& use = map_[column];
    return use ? std::string(trimmed(names_[use->index])) : std::string();
  };
  const auto count = [&](std::size_t rows, LogColumn column, std::string_view what) {
    if (rows > 0) out.push_back(fmt::format("{} rows: '{}' {}", rows, named(column), what));
  };
  count(bad_times_, LogColumn::kTime, "is no time as in the first row and counts as not recorded");
  count(bad_work_, LogColumn::kWork,
        "is neither on (1, in, down) nor off (0, out, up) and counts as not recorded");
  count(bad_widths_, LogColumn::kWidth, "is no width and counts as not recorded");
  count(bad_rates_, LogColumn::kRate, "is no applied rate and counts as not recorded");
  if (bad_sections_ > 0)
    out.push_back(fmt::format("{} rows: the states of sections are not understood", bad_sections_));
  if (sections_without_width_ > 0)
    out.push_back(
        fmt::format("{} rows say which sections work but not how wide each is: taken as one section",
                    sections_without_width_));
  if (units_.size() > 1) {
    std::string columns;
    for (const LogColumn column : kUnitColumns)
      if (map_[column]) columns += (columns.empty() ? "" : ", ") + named(column);
    out.push_back(fmt::format(
        "{} units by {}: each is evaluated as a unit of its own, with its positions as its middle",
        units_.size(), columns));
  }
  return out;
}

}  // namespace tramline::io
