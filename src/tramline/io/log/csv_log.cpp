#include "tramline/io/log/csv_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/fixes/most_fixes.h"
#include "tramline/io/fixes/number_text.h"
#include "tramline/io/log/settle_positions.h"
#include "tramline/io/log/width_unit.h"

namespace tramline::io {
namespace {

/// A row without quotes, cell by cell.
void split_plain(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  for (std::size_t end = 0; end != std::string_view::npos;) {
    end = line.find(separator);
    cells.push_back(line.substr(0, end));
    if (end != std::string_view::npos) line.remove_prefix(end + 1);
  }
}

enum class RowPart { kBegin, kWithinQuotes };

/// A row with quotes, or what follows in one that was left open; "" within them is a quote. Returns whether a
/// quoted field is left open at the end.
bool split_quoted(std::string_view line, char separator, std::vector<std::string>& cells,
                  RowPart part = RowPart::kBegin) {
  cells.clear();
  cells.emplace_back();
  bool quoted = part == RowPart::kWithinQuotes, at_start = !quoted;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted) {
      if (c != '"')
        cells.back() += c;
      else if (i + 1 < line.size() && line[i + 1] == '"')
        cells.back() += line[++i];
      else
        quoted = false;
    } else if (c == '"' && at_start) {
      quoted = true;
    } else if (c == separator) {
      cells.emplace_back();
      at_start = true;
      continue;
    } else {
      cells.back() += c;
    }
    at_start = false;
  }
  return quoted;
}

bool is_comment(std::string_view line) {
  return line.starts_with('#') || line.starts_with('%') || line.starts_with("//");
}

char separator_of(std::string_view header) {
  constexpr std::array kSeparators = {',', ';', '\t'};
  std::array<std::size_t, kSeparators.size()> counts{};
  bool quoted = false;
  for (const char c : header) {
    if (c == '"') quoted = !quoted;
    for (std::size_t i = 0; i < kSeparators.size(); ++i)
      if (!quoted && c == kSeparators[i]) ++counts[i];
  }
  const auto most = std::max_element(counts.begin(), counts.end());
  return kSeparators[static_cast<std::size_t>(most - counts.begin())];
}

}  // namespace

CsvLog::CsvLog(std::string columns, std::string place)
    : columns_(std::move(columns)), place_(std::move(place)) {}

std::optional<Fix> CsvLog::add(std::string_view line) {
  ++line_;
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (line_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
  if (line_ == 1 && (line.starts_with("\xFF\xFE") || line.starts_with("\xFE\xFF")))
    throw bad_input(fmt::format("{} is text in UTF-16; save it as UTF-8", place_));
  if (!open_row_.empty()) {
    if (open_row_.size() + line.size() > kLongestLine)
      throw bad_input(fmt::format("{}, line {}: a quoted field is never closed", place_, open_line_));
    open_row_ += '\n';
    open_row_ += line;
    // The line alone tells: a row of many lines would be split as often.
    if (split_quoted(line, separator_, quoted_cells_, RowPart::kWithinQuotes)) return std::nullopt;
    const std::string whole = std::exchange(open_row_, {});
    return row(whole, open_line_);
  }
  const std::string_view text = trimmed(line);
  if (text.empty() || states_.add(text, line_, bad_states_) || is_comment(text)) return std::nullopt;
  if (rows_ && line == header_) return std::nullopt;
  if (!rows_) {
    read_header(line);
    return std::nullopt;
  }
  return row(line, line_);
}

void CsvLog::read_header(std::string_view line) {
  if (line.size() == 5 && lower_case(line).starts_with("sep=")) {
    separator_ = line[4];
    return;
  }
  if (separator_ == 0) separator_ = separator_of(line);
  split_quoted(line, separator_, quoted_cells_);
  const auto is_number = [](const std::string& cell) { return number_in(cell).has_value(); };
  if (std::count_if(quoted_cells_.begin(), quoted_cells_.end(), is_number) >= 2)
    throw bad_input(
        fmt::format("{}, line {}: numbers stand where the names of the columns should; put a line such as "
                    "lon,lat,time first",
                    place_, line_));
  header_ = line;
  rows_.emplace(quoted_cells_, TableForm{place_, columns_, PositionSource::kTable, separator_ != ','});
}

std::optional<Fix> CsvLog::row(std::string_view line, std::size_t record) {
  std::optional<Fix> fix;
  if (line.find('"') == std::string_view::npos) {
    split_plain(line, separator_, cells_);
  } else if (split_quoted(line, separator_, quoted_cells_)) {
    open_row_ = line;
    open_line_ = record;
    return std::nullopt;
  } else {
    cells_.assign(quoted_cells_.begin(), quoted_cells_.end());
  }
  fix = rows_->add(cells_, record);
  if (fix) states_.apply(*fix, rows_->boom_list(), own_columns());
  return fix;
}

OwnColumns CsvLog::own_columns() const {
  if (!rows_) return {};
  return {rows_->has(LogColumn::kWork) || rows_->has(LogColumn::kSections) ||
              rows_->has(LogColumn::kSectionsFromRight) || rows_->has(LogColumn::kCondensed),
          rows_->has(LogColumn::kWidth)};
}

SkippedRecords CsvLog::skipped() const {
  SkippedRecords out = rows_ ? rows_->skipped() : SkippedRecords{};
  out.add(bad_states_);
  return out;
}

WorkLog work_log_of(const CsvLog& csv, std::vector<Fix> fixes, std::span<const RecordedDistance> distances,
                    const std::string& crs, const std::string& place, double* width_unit_m) {
  assert(csv.rows() != nullptr);
  WorkLog log;
  log.fixes = std::move(fixes);
  log.booms = csv.rows()->booms();
  log.clock = csv.rows()->clock();
  log.rate_unit = csv.rows()->rate_unit();
  log.counters = csv.rows()->counters();
  log.skipped = csv.skipped();
  log.notes = csv.rows()->notes();
  if (!csv.own_columns().work) work_before(log, csv.states());
  settle_positions(log, csv.rows()->position_names(), crs, place);
  const double unit_m = csv.rows()->width_unit_open() ? settle_width_unit(log, distances) : 1;
  if (width_unit_m != nullptr) *width_unit_m = unit_m;
  return log;
}

WorkLog read_csv_log(Lines& lines, const std::string& columns, const std::string& crs,
                     const std::string& place) {
  CsvLog csv(columns, place);
  std::vector<Fix> fixes;
  std::vector<RecordedDistance> distances;
  std::string line;
  while (lines.next(line)) {
    const auto fix = csv.add(line);
    if (!fix) continue;
    require_room_for_fix(fixes.size(), place);
    fixes.push_back(*fix);
    if (std::isfinite(csv.rows()->last_distance()))
      distances.push_back({fix->record, csv.rows()->last_distance()});
  }
  if (csv.rows() == nullptr) throw bad_input(fmt::format("{} is empty; give a log with records", place));
  if (fixes.empty())
    throw bad_input(fmt::format("{} has no row with a position; check its columns and separators", place));
  std::vector<std::string> faults;
  if (csv.in_quotes()) faults.emplace_back("the last quoted field is never closed; its row was left out");
  if (!lines.cut_off().empty()) faults.push_back(lines.cut_off() + "; the rows before were read");
  WorkLog log = work_log_of(csv, std::move(fixes), distances, crs, place);
  log.notes.insert(log.notes.end(), faults.begin(), faults.end());
  return log;
}

}  // namespace tramline::io
