#include "tramline/io/machine/read_machine.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "tramline/geometry/error.h"
#include "tramline/model/limits.h"

namespace tramline::io {
namespace {

constexpr std::array<std::string_view, 4> kKeys = {"name", "width_m", "turning_radius_m",
                                                   "min_track_length_m"};
// Far above any machine file: what is longer is something else.
constexpr std::size_t kLargestFile = 1 << 20;
// Each dot of a key is a table within a table, and tables are taken apart by a call for each.
constexpr std::ptrdiff_t kMostDots = 64;

struct Source {
  std::string file;
  toml::table table;
};

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(kLargestFile + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad() || (!file.eof() && file.fail()))
    throw bad_input(fmt::format("machine file {}: it cannot be read", path.string()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > kLargestFile)
    throw bad_input(fmt::format("machine file {}: it is too long for a machine file", path.string()));
  return text;
}

/// Looked at before the text is parsed. Lines end where TOML++ ends them; a comment may be full of dots.
void refuse_deep_keys(std::string_view text, const std::filesystem::path& path) {
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find_first_of("\n\v\f\r"), text.size());
    const std::string_view row = text.substr(0, end);
    const bool comment = row.substr(std::min(row.find_first_not_of(" \t"), row.size())).starts_with('#');
    if (!comment && std::count(row.begin(), row.end(), '.') > kMostDots)
      throw bad_input(fmt::format(
          "machine file {}, line {}: it has more than {} dots; a machine file has no nested tables",
          path.string(), line, kMostDots));
    text.remove_prefix(std::min(end + (text.substr(end).starts_with("\r\n") ? 2 : 1), text.size()));
  }
}

Source parse(const std::filesystem::path& path) {
  const std::string text = text_of(path);
  refuse_deep_keys(text, path);
  try {
    return {path.string(), toml::parse(text)};
  } catch (const toml::parse_error& error) {
    throw bad_input(fmt::format("machine file {}, line {}: it is not valid TOML ({})", path.string(),
                                error.source().begin.line, error.description()));
  }
}

[[noreturn]] void refuse(const Source& source, const toml::source_region& place, const std::string& what) {
  throw bad_input(fmt::format("machine file {}, line {}: {}", source.file, place.begin.line, what));
}

void refuse_unknown_keys(const Source& source) {
  for (const auto& [key, value] : source.table) {
    bool known = false;
    for (const std::string_view name : kKeys) known = known || key.str() == name;
    if (!known)
      refuse(source, key.source(),
             fmt::format("{} is no key of a machine; known are {}", key.str(), fmt::join(kKeys, ", ")));
  }
}

std::optional<double> length_m(const Source& source, std::string_view key, bool zero_allowed) {
  const toml::node* node = source.table.get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_number()) refuse(source, node->source(), fmt::format("{} must be a number of metres", key));
  const double value = node->value<double>().value_or(std::nan(""));
  if (!(value >= 0 && value <= kFarthest_m) || (value == 0 && !zero_allowed))
    refuse(source, node->source(),
           fmt::format("{} is {:g}, but must be a length {} 0 m and at most {} m", key, value,
                       zero_allowed ? "of at least" : "above", kFarthest_m));
  return value;
}

}  // namespace

Machine read_machine(const std::filesystem::path& path) {
  const Source source = parse(path);
  refuse_unknown_keys(source);
  Machine machine;
  if (const toml::node* name = source.table.get("name")) {
    if (!name->is_string()) refuse(source, name->source(), "name must be a text in quotes");
    machine.name = name->value<std::string>().value_or("");
  }
  const auto width = length_m(source, "width_m", false);
  if (!width)
    throw bad_input(fmt::format("machine file {}: width_m, the working width, is missing", source.file));
  machine.width_m = *width;
  machine.radius_m = length_m(source, "turning_radius_m", true).value_or(machine.radius_m);
  machine.min_length_m = length_m(source, "min_track_length_m", true).value_or(machine.min_length_m);
  return machine;
}

}  // namespace tramline::io
