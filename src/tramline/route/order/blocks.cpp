#include "tramline/route/order/blocks.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace tramline::order {
namespace {

/// Neighbouring tracks are a width apart, but for rounding and chords; lines closer together lie one behind
/// the other.
constexpr double kFarthest_widths = 1.01, kNearest_widths = 0.5;

/// The path of a line; without detours for a straight one.
struct Course {
  Path path;
  Box box;
};

Course course_of(const WorkedLine& line) {
  Course out;
  for (const TrackPiece& piece : line)
    out.path.insert(out.path.end(), piece.curve.begin(), piece.curve.end());
  if (out.path.empty()) out.path = straight_path(line.front().start, line.back().end);
  out.box = reach_of(out.path, 0);
  return out;
}

bool lies_beside(const Course& course, Point p, double width_m) {
  Box around;
  around.extend(p);
  if (!intersects(course.box, around.grown(kFarthest_widths * width_m))) return false;
  double off = std::numeric_limits<double>::infinity();
  for (const PathSegment& segment : course.path) off = std::min(off, distance_to_edge(segment, p, p));
  return off >= kNearest_widths * width_m && off <= kFarthest_widths * width_m;
}

bool face(const Course& a, const Course& b, double width_m) {
  return lies_beside(a, b.path.front().from, width_m) || lies_beside(a, b.path.back().to, width_m) ||
         lies_beside(b, a.path.front().from, width_m) || lies_beside(b, a.path.back().to, width_m);
}

/// The lines that a line faces on the track before or after it.
struct Facing {
  std::size_t line = 0;
  int count = 0;
  void add(std::size_t other) {
    line = other;
    ++count;
  }
};

}  // namespace

std::vector<Block> blocks_of(const std::vector<WorkedLine>& lines, double width_m) {
  std::vector<Course> courses;
  std::map<std::pair<std::size_t, int>, std::vector<std::size_t>> tracks;  // by subfield and track
  for (std::size_t i = 0; i < lines.size(); ++i) {
    courses.push_back(course_of(lines[i]));
    tracks[{lines[i].front().subfield, lines[i].front().track}].push_back(i);
  }
  std::vector<Facing> behind(lines.size()), before(lines.size());
  for (auto track = tracks.begin(), next = track; track != tracks.end(); track = next) {
    if (++next == tracks.end()) break;
    if (next->first.first != track->first.first || next->first.second != track->first.second + 1) continue;
    for (const std::size_t a : track->second)
      for (const std::size_t b : next->second)
        if (face(courses[a], courses[b], width_m)) {
          behind[a].add(b);
          before[b].add(a);
        }
  }
  const auto goes_on = [&](std::size_t a) {
    return behind[a].count == 1 && before[behind[a].line].count == 1;
  };
  std::vector<Block> out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (before[i].count == 1 && goes_on(before[i].line)) continue;
    Block block{i};
    while (goes_on(block.back())) block.push_back(behind[block.back()].line);
    out.push_back(std::move(block));
  }
  return out;
}

}  // namespace tramline::order
