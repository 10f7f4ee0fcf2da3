#include "tramline/io/agopengps/field_rows.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "tramline/geometry/error.h"
#include "tramline/io/fixes/lines.h"
#include "tramline/io/fixes/number_text.h"

namespace tramline::io {
namespace {

std::vector<std::string> between_commas(std::string_view line) {
  std::vector<std::string> out;
  for (std::size_t comma = 0; comma != std::string_view::npos;) {
    comma = line.find(',');
    out.emplace_back(trimmed(line.substr(0, comma)));
    line.remove_prefix(comma == std::string_view::npos ? line.size() : comma + 1);
  }
  return out;
}

/// As many numbers, of a line with decimal points or, twice as many parts, with decimal commas.
std::optional<std::vector<double>> numbers_in(std::string_view line, std::size_t count) {
  const std::vector<std::string> parts = between_commas(line);
  const bool commas = parts.size() == 2 * count;
  if (!commas && parts.size() != count) return std::nullopt;
  std::vector<double> out;
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = number_in(commas ? parts[2 * i] + "." + parts[2 * i + 1] : parts[i]);
    if (!value) return std::nullopt;
    out.push_back(*value);
  }
  return out;
}

}  // namespace

FieldRows::FieldRows(const std::string& path) : path_(path) {
  FileLines lines(path);
  for (std::string line; lines.next(line);) lines_.emplace_back(trimmed(line));
  while (!lines_.empty() && lines_.back().empty()) lines_.pop_back();
}

std::string FieldRows::text() {
  if (at_end())
    throw bad_input(fmt::format("'{}' ends after line {}, in the middle of a list; copy the folder again",
                                path_, lines_.size()));
  return lines_[next_++];
}

std::string_view FieldRows::ahead() const { return at_end() ? std::string_view() : lines_[next_]; }

std::vector<double> FieldRows::numbers(std::size_t count) {
  const std::string line = text();
  auto out = numbers_in(line, count);
  if (!out) refuse(fmt::format("{} number{} expected, not '{}'", count, count == 1 ? "" : "s", line));
  return *std::move(out);
}

std::size_t FieldRows::count() {
  const std::string line = text();
  const auto out = digits_in(line);
  if (!out) refuse(fmt::format("a count of points is expected, not '{}'", line));
  if (*out < 0 || static_cast<std::size_t>(*out) > lines_.size() - next_)
    refuse(fmt::format("{} points are announced, and {} lines follow", *out, lines_.size() - next_));
  return static_cast<std::size_t>(*out);
}

Point FieldRows::place() {
  const std::string line = text();
  auto values = numbers_in(line, 3);
  if (!values) values = numbers_in(line, 2);
  if (!values) refuse(fmt::format("easting, northing and heading are expected, not '{}'", line));
  const Point out{(*values)[0], (*values)[1]};
  if (!(std::abs(out.x) <= kFarthest_m && std::abs(out.y) <= kFarthest_m))
    refuse(fmt::format("({:g}, {:g}) is farther than {:.0f} km from where the field was started", out.x,
                       out.y, kFarthest_m / 1000));
  return out;
}

std::vector<Point> FieldRows::places(std::size_t count) {
  std::vector<Point> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(place());
  return out;
}

void FieldRows::refuse(const std::string& what) const {
  throw bad_input(fmt::format("'{}', line {}: {}", path_, next_, what));
}

}  // namespace tramline::io
