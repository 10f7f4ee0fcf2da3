#include "tramline/planner/repair/driven_directions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "tramline/geometry/index/box_grid.h"
#include "tramline/geometry/path/simplified_line.h"
#include "tramline/geometry/polygon/bounding_rectangle.h"
#include "tramline/geometry/strip/track_frame.h"

namespace tramline {
namespace {

constexpr double kWobble_m = 0.1;  ///< of a drive along a straight line
constexpr double kSameDirection_deg = 0.5;
constexpr double kOwnLength_deg = 10;  ///< a gap's own length counts as the driven direction up to here
constexpr double kSlim = 3;
constexpr int kBins = 180;

struct Way {
  Point from;
  Point to;
};

/// The length of a way within a box, m.
double length_within(const Way& way, const Box& box) {
  double from = 0, to = 1;
  const Point step = way.to - way.from;
  const auto clip = [&](double at, double along, double low, double high) {
    if (along == 0) return at >= low && at <= high;
    const double a = (low - at) / along, b = (high - at) / along;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
    return from < to;
  };
  if (!clip(way.from.x, step.x, box.min_x, box.max_x) || !clip(way.from.y, step.y, box.min_y, box.max_y))
    return 0;
  return (to - from) * length(step);
}

/// Metres driven by direction.
class Rose {
 public:
  void add(const Way& way, double way_m) {
    const double degrees = Direction::along(way.from, way.to).degrees();
    const double doubled = 2 * Angle::degrees(degrees).radians();
    Bin& bin = bins_[static_cast<std::size_t>(degrees) % kBins];
    bin.way_m += way_m;
    bin.sum = bin.sum + way_m * Point{std::cos(doubled), std::sin(doubled)};
    whole_m_ += way_m;
  }
  double whole_m() const { return whole_m_; }

  /// The directions with most of the way within two degrees, 15° apart at least; each has at least `share`
  /// of the way of the first.
  std::vector<Direction> peaks(double share, std::size_t most) const {
    constexpr int kAside = 2, kApart = 15;
    std::array<Bin, kBins> around;
    for (int i = 0; i < kBins; ++i)
      for (int k = -kAside; k <= kAside; ++k) {
        const Bin& bin = bins_[static_cast<std::size_t>((i + k + kBins) % kBins)];
        around[static_cast<std::size_t>(i)].way_m += bin.way_m;
        around[static_cast<std::size_t>(i)].sum = around[static_cast<std::size_t>(i)].sum + bin.sum;
      }
    std::vector<Direction> out;
    double first_m = 0;
    while (out.size() < most) {
      const auto best = std::max_element(around.begin(), around.end(),
                                         [](const Bin& a, const Bin& b) { return a.way_m < b.way_m; });
      if (!(best->way_m > 0) || best->way_m < share * first_m) break;
      if (out.empty()) first_m = best->way_m;
      out.push_back(
          Direction::clockwise_from_north(Angle::radians(0.5 * std::atan2(best->sum.y, best->sum.x))));
      const auto at = static_cast<int>(best - around.begin());
      for (int k = -kApart; k <= kApart; ++k) around[static_cast<std::size_t>((at + k + kBins) % kBins)] = {};
    }
    return out;
  }

 private:
  struct Bin {
    double way_m = 0;
    Point sum;  ///< of unit vectors at twice the angle, by way
  };
  std::array<Bin, kBins> bins_;
  double whole_m_ = 0;
};

/// The way at work, indexed by position to find what was driven near a gap.
class WorkedWay {
 public:
  explicit WorkedWay(const std::vector<DrivenLine>& driven) {
    std::vector<Box> boxes;
    for (const DrivenLine& line : driven) {
      if (line.run < 0) continue;
      const std::vector<std::size_t> kept = simplified_line(line.line, kWobble_m);
      for (std::size_t i = 1; i < kept.size(); ++i) {
        const Way way{line.line[kept[i - 1]], line.line[kept[i]]};
        whole_.add(way, distance(way.from, way.to));
        ways_.push_back(way);
        boxes.push_back(bounds(way.from, way.to));
      }
    }
    grid_ = BoxGrid(boxes);
  }

  bool empty() const { return !(whole_.whole_m() > 0); }
  const Rose& whole() const { return whole_; }

  Rose near(const Box& box, double width_m) const {
    constexpr double kFarthest_widths = 300;
    for (double reach_m = width_m; reach_m < kFarthest_widths * width_m; reach_m *= 4) {
      Rose out;
      const Box window = box.grown(reach_m);
      grid_.each_meeting(window, [&](std::size_t i) {
        if (const double way_m = length_within(ways_[i], window); way_m > 0) out.add(ways_[i], way_m);
      });
      if (out.whole_m() > width_m) return out;
    }
    return whole_;
  }

 private:
  std::vector<Way> ways_;
  BoxGrid grid_;
  Rose whole_;
};

/// The index of the direction, as a new one where none is so near.
std::size_t index_of(Direction direction, std::vector<Direction>& known) {
  const auto found = std::find_if(known.begin(), known.end(), [&](Direction other) {
    return angle_between(direction, other).degrees() <= kSameDirection_deg;
  });
  const auto index = static_cast<std::size_t>(found - known.begin());
  if (found == known.end()) known.push_back(direction);
  return index;
}

/// Along the length of a slim gap.
std::optional<Direction> own_length(const Gap& gap) {
  const Direction axis = long_side_of_smallest_rectangle(gap.shape.outer);
  const Box box = bounds(TrackFrame(axis).to_track(gap.shape.outer));
  return box.height() >= kSlim * box.width() ? std::optional(axis) : std::nullopt;
}

}  // namespace

DrivenDirections driven_directions(const std::vector<Gap>& gaps, const std::vector<DrivenLine>& driven,
                                   double width_m) {
  constexpr double kSecond = 1.0 / 3;
  constexpr std::size_t kMostOfGap = 2, kMostOfDrive = 4;
  const WorkedWay way(driven);
  DrivenDirections out;
  if (!way.empty()) out.directions = way.whole().peaks(0.1, kMostOfDrive);
  for (const Gap& gap : gaps) {
    std::vector<std::size_t>& of_gap = out.of_gaps.emplace_back();
    const auto add = [&](Direction direction) {
      const std::size_t index = index_of(direction, out.directions);
      if (std::find(of_gap.begin(), of_gap.end(), index) == of_gap.end()) of_gap.push_back(index);
    };
    std::vector<Direction> near;
    if (!way.empty()) near = way.near(bounds(gap.shape), width_m).peaks(kSecond, kMostOfGap);
    for (const Direction direction : near) add(direction);
    const std::optional<Direction> own = own_length(gap);
    const bool keeps = own && std::any_of(near.begin(), near.end(), [&](Direction direction) {
                         return angle_between(direction, *own).degrees() <= kOwnLength_deg;
                       });
    if (keeps) add(*own);
    if (of_gap.empty()) add(own.value_or(long_side_of_smallest_rectangle(gap.shape.outer)));
  }
  return out;
}

}  // namespace tramline
