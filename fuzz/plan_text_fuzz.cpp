// Any text in the place of the texts of a plan file: paths, stretches of turns and routes, detours, numbers
// of obstacles, a front's directions and marks, and the table of keys and values. What is read has to be
// written back to what reads the same.
//
// The first byte picks the reader, '0' the first. Two texts of one reader are parted by a line of three
// dashes.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/plan/detour_text.h"
#include "tramline/io/plan/front_text.h"
#include "tramline/io/plan/path_text.h"
#include "tramline/io/plan/plan_metadata.h"
#include "tramline/io/plan/turn_text.h"

namespace {

using namespace tramline;

const std::string kPlace = "fuzz";

void demand(bool holds) {
  if (!holds) std::abort();
}

void read_path(const std::string& text) {
  const Path path = io::path_from_text(text, {}, kPlace);
  demand(!path.empty());
  for (std::size_t i = 0; i + 1 < path.size(); ++i) demand(path[i].to == path[i + 1].from);
  demand(io::path_from_text(io::path_text(path, {}), {}, kPlace) == path);
  // Coordinates may be so large that the offset swallows them, but not the reader.
  io::path_from_text(text, {500000, 5800000}, kPlace);
}

void read_points(const std::string& text) {
  const std::vector<Point> points = io::points_from_text(text, {}, kPlace);
  demand(io::points_from_text(io::points_text(points, {}), {}, kPlace) == points);
}

/// They can be drawn, whatever the file says.
void read_stretches(const std::string& text) {
  const SteeredPath path = io::steered_from_text(text, {}, kPlace);
  const std::string written = io::steered_text(path, {});
  demand(io::steered_text(io::steered_from_text(written, {}, kPlace), {}) == written);
  constexpr std::size_t kMostDrawn = 20;
  if (path.size() <= kMostDrawn) trace(path, 0.01);
}

/// What a file counts from 1 fits an int.
void demand_indices(const std::vector<std::size_t>& indices) {
  for (const std::size_t index : indices) demand(index < std::numeric_limits<int>::max());
}

void demand_within(const TrackPiece& piece, const Path& path) {
  std::size_t segments = 0;
  for (const Detour& detour : piece.detours) {
    demand(!detour.path.empty());
    segments += detour.path.size();
    demand_indices(detour.obstacles);
  }
  demand(segments <= path.size());
}

void read_piece(const std::string& path_text, const std::string& detours) {
  const Path path = io::path_from_text(path_text, {}, kPlace);
  demand_within(io::curved_piece(path, detours, kPlace), path);
  const TrackPiece piece = io::piece_from_text(path, detours, kPlace);
  demand_within(piece, path);
  io::obstacles_avoided(piece);
  io::sides_text(piece);
}

void read_numbers(const std::string& text) {
  const std::vector<std::size_t> numbers = io::obstacles_from_text(text, kPlace);
  demand_indices(numbers);
  demand(io::obstacles_from_text(io::obstacles_text(numbers), kPlace) == numbers);
}

void read_front(const std::string& directions, const std::string& marks) {
  for (const Direction direction : io::directions_from_text(directions, kPlace))
    demand(std::isfinite(direction.degrees()));
  FrontMarks read;
  io::apply_marks(marks, 3, kPlace, read);
}

void demand_written_back(const Plan& plan) {
  const io::Metadata written = io::metadata_of(plan);
  Plan again;
  try {
    io::apply_metadata(written, "fuzz.gpkg", again);
  } catch (const Error&) {
    std::abort();  // what could be read once can be read again
  }
  demand(io::metadata_of(again) == written);
}

/// A whole table of keys of which one or more are replaced: lines "key=value".
void read_metadata(std::string_view text) {
  static const io::Metadata sound = [] {
    Plan plan;
    plan.field.id = "fuzz";
    plan.field.outer = {{0, 0}, {100, 0}, {100, 6}, {0, 6}};
    plan.field.frame = {true, 13, 52, 0, 0};
    return io::metadata_of(plan);
  }();
  io::Metadata metadata = sound;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::size_t equals = line.find('=');
    if (equals != std::string_view::npos)
      metadata[std::string(line.substr(0, equals))] = line.substr(equals + 1);
  }
  Plan plan;
  io::apply_metadata(metadata, "fuzz.gpkg", plan);
  demand(std::isfinite(plan.machine.width_m) && std::isfinite(plan.tally.worked_m2));
  demand_written_back(plan);
}

void read_any(int reader, const std::string& text) {
  const std::size_t split = text.find("\n---\n");
  const std::string first = text.substr(0, split);
  const std::string second = split == std::string::npos ? std::string("[]") : text.substr(split + 5);
  switch (reader) {
    case 0:
      return read_path(text);
    case 1:
      return read_points(text);
    case 2:
      return read_piece(first, second);
    case 3:
      return read_numbers(text);
    case 4:
      return read_front(first, second);
    case 5:
      return read_metadata(text);
    default:
      return read_stretches(text);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    constexpr int kReaders = 7;
    read_any((data[0] + kReaders - '0' % kReaders) % kReaders,
             {reinterpret_cast<const char*>(data) + 1, size - 1});
  } catch (const tramline::Error&) {
    // A refusal is an answer; any other exception is a fault.
  }
  return 0;
}
