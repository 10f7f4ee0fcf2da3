#include "tramline/io/pattern/read_pattern.h"

#include "tramline/io/pattern/pattern_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/fixes/lines.h"
#include "tramline/io/fixes/number_text.h"

namespace tramline::io {
namespace {

constexpr std::size_t kMostRows = 10000;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

bool is_comment(std::string_view text) {
  return text.starts_with('#') || text.starts_with('%') || text.starts_with("//");
}

std::vector<std::string> cells_of(std::string_view text) {
  const bool decimal_comma = text.find_first_of(";\t") != std::string_view::npos;
  const char* separators = decimal_comma ? ";\t" : text.find(',') != std::string_view::npos ? "," : " ";
  std::vector<std::string> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(separators), text.size());
    const std::string_view cell = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (cell.empty() && *separators == ' ') continue;
    out.emplace_back(cell);
    if (decimal_comma) std::replace(out.back().begin(), out.back().end(), ',', '.');
  }
  return out;
}

}  // namespace

SprayPattern read_pattern(const std::string& path) {
  FileLines lines(path);
  return read_pattern(lines, path);
}

SprayPattern read_pattern(Lines& lines, const std::string& name) {
  SprayPattern out;
  std::string line;
  bool may_be_names = true;
  for (std::size_t number = 1; lines.next(line); ++number) {
    std::string_view text = line;
    if (number == 1 && text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    text = trimmed(text);
    if (text.empty() || is_comment(text)) continue;
    const std::vector<std::string> cells = cells_of(text);
    const bool two = cells.size() == 2;
    const double offset_m = two ? number_in(cells[0]).value_or(kNone) : kNone;
    const double rate = two ? number_in(cells[1]).value_or(kNone) : kNone;
    const bool names = may_be_names && two && std::isnan(offset_m) && std::isnan(rate);
    may_be_names = false;
    if (names) continue;
    const std::string place = fmt::format("pattern '{}', line {}", name, number);
    if (std::isnan(offset_m) || std::isnan(rate))
      throw bad_input(fmt::format(
          "{}: not two numbers; each line is an offset in metres and a relative rate, such as -6,0.8",
          place));
    if (rate < 0) throw bad_input(fmt::format("{}: the rate is {:g}; rates are 0 or more", place, rate));
    if (out.size() == kMostRows)
      throw bad_input(fmt::format("{}: more than {} rows; is this a pattern?", place, kMostRows));
    out.push_back({offset_m, rate});
  }
  if (out.empty())
    throw bad_input(fmt::format(
        "pattern '{}' holds no rows; each line is an offset in metres and a relative rate", name));
  return out;
}

}  // namespace tramline::io
