#include "tramline/io/plan/detour_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "tramline/geometry/error.h"
#include "tramline/io/plan/plan_layers.h"
#include "tramline/model/plan.h"

namespace tramline::io {
namespace {

using nlohmann::json;

std::vector<std::size_t> numbers_for_people(const std::vector<std::size_t>& indices) {
  std::vector<std::size_t> out;
  for (const std::size_t index : indices) out.push_back(index + 1);
  return out;
}

/// A whole number from 0 (or `least`) on, as an index into something.
std::size_t whole(const json& value, int least) {
  if (!value.is_number_integer()) throw json::other_error::create(0, "not a whole number", nullptr);
  const auto number = value.get<long long>();
  if (number < least || number > std::numeric_limits<int>::max())
    throw json::other_error::create(0, "out of range", nullptr);
  return static_cast<std::size_t>(number);
}

struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
  Passing side = Passing::kLeft;
  std::vector<std::size_t> obstacles;
};

std::vector<Stretch> stretches_from(const std::string& text, const std::string& place) {
  std::vector<Stretch> out;
  try {
    const json list = json::parse(text);
    if (!list.is_array()) throw json::other_error::create(0, "no list", nullptr);
    for (const json& item : list) {
      Stretch stretch;
      stretch.first = whole(item.at("first"), 0);
      stretch.last = whole(item.at("last"), 0);
      const auto side = passing_named(item.at("side").get<std::string>());
      if (!side || *side == Passing::kCut) throw json::other_error::create(0, "no side", nullptr);
      stretch.side = *side;
      for (const json& number : item.at("obstacles")) stretch.obstacles.push_back(whole(number, 1) - 1);
      out.push_back(std::move(stretch));
    }
  } catch (const json::exception&) {
    throw bad_input(place + " is no JSON list of detours; write the plan again");
  }
  return out;
}

/// Between two detours, or before the first, there is one straight segment or none.
void require_straight(const Path& path, std::size_t begin, std::size_t end, const std::string& place) {
  if (end - begin > 1 || (end - begin == 1 && !path[begin].straight()))
    throw bad_input(
        fmt::format("{} leaves out segments from {} on that are not one straight line; write the plan again",
                    place, begin));
}

/// A detour begins where the one before has ended, at segment `free_from`, or later.
void require_order(const Stretch& stretch, std::size_t free_from, const Path& path,
                   const std::string& place) {
  if (stretch.first < free_from || stretch.last < stretch.first || stretch.last >= path.size())
    throw bad_input(fmt::format("{} names segments {} to {} after {} of {}; write the plan again", place,
                                stretch.first, stretch.last, free_from, path.size()));
}

TrackPiece piece_with(const Path& path, const std::vector<Stretch>& stretches) {
  TrackPiece out;
  out.start = path.front().from;
  out.end = path.back().to;
  for (const Stretch& stretch : stretches) {
    const auto first = path.begin() + static_cast<std::ptrdiff_t>(stretch.first);
    const auto last = path.begin() + static_cast<std::ptrdiff_t>(stretch.last);
    out.detours.push_back({{first, last + 1}, stretch.side, stretch.obstacles});
  }
  return out;
}

}  // namespace

std::string obstacles_text(const std::vector<std::size_t>& indices) {
  return fmt::format("{}", fmt::join(numbers_for_people(indices), ", "));
}

std::vector<std::size_t> obstacles_from_text(const std::string& text, const std::string& place) {
  std::vector<std::size_t> out;
  std::string_view rest = text;
  while (!rest.empty()) {
    int number = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    if (error == std::errc{} && number >= 1 &&
        (rest.empty() || (rest.starts_with(", ") && rest.size() > 2))) {
      out.push_back(static_cast<std::size_t>(number) - 1);
      rest.remove_prefix(rest.empty() ? 0 : 2);
      continue;
    }
    throw bad_input(fmt::format("{} is '{}', expected obstacle numbers such as 3, 7", place, text));
  }
  return out;
}

std::string obstacles_avoided(const TrackPiece& piece) {
  std::set<std::size_t> all;
  for (const Detour& detour : piece.detours) all.insert(detour.obstacles.begin(), detour.obstacles.end());
  return obstacles_text({all.begin(), all.end()});
}

std::string sides_text(const TrackPiece& piece) {
  std::vector<const char*> sides;
  for (const Detour& detour : piece.detours) sides.push_back(name(detour.side));
  return fmt::format("{}", fmt::join(sides, ", "));
}

const char* kind_of(const TrackPiece& piece) {
  if (!piece.curve.empty()) return plan_layers::kCurved;
  return piece.detours.empty() ? plan_layers::kStraight : plan_layers::kDetour;
}

Path written_path(const TrackPiece& piece) {
  if (!piece.curve.empty()) return piece.curve;
  return piece.detours.empty() ? straight_path(piece.start, piece.end) : centre_line(piece);
}

std::string detours_text(const TrackPiece& piece) {
  const Path path = written_path(piece);
  json list = json::array();
  std::size_t at = 0;
  for (const Detour& detour : piece.detours) {
    const auto begin = path.begin() + static_cast<std::ptrdiff_t>(at);
    const auto first =
        static_cast<std::size_t>(std::find(begin, path.end(), detour.path.front()) - path.begin());
    at = first + detour.path.size();
    list.push_back({{"first", first},
                    {"last", at - 1},
                    {"side", name(detour.side)},
                    {"obstacles", numbers_for_people(detour.obstacles)}});
  }
  return list.dump();
}

TrackPiece piece_from_text(const Path& path, const std::string& detours, const std::string& place) {
  const std::vector<Stretch> stretches = stretches_from(detours, place);
  std::size_t at = 0;
  for (const Stretch& stretch : stretches) {
    require_order(stretch, at, path, place);
    require_straight(path, at, stretch.first, place);
    at = stretch.last + 1;
  }
  require_straight(path, at, path.size(), place);
  return piece_with(path, stretches);
}

TrackPiece curved_piece(const Path& path, const std::string& detours, const std::string& place) {
  const std::vector<Stretch> stretches = stretches_from(detours, place);
  std::size_t at = 0;
  for (const Stretch& stretch : stretches) {
    require_order(stretch, at, path, place);
    at = stretch.last + 1;
  }
  TrackPiece out = piece_with(path, stretches);
  out.curve = path;
  return out;
}

}  // namespace tramline::io
