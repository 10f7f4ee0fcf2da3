#include "tramline/check/prices/dearest_piece.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/check/prices/detour_reach.h"

namespace tramline::check {
namespace {

/// Samples across the width of the first look; each further one has twice as many.
constexpr int kFirstSamples = 3, kLooks = 4;
/// What is within reach of a sample, in steps: its corners, half a step to the next offset, and the turn.
constexpr double kTurn_steps = 0.3;
constexpr double kReach_steps = std::numbers::sqrt2 / 2 + 0.5 + kTurn_steps;
/// Pixels of the ground, by step.
constexpr double kPixel_steps = 0.4;

/// Left edges of swaths, across from the pivot.
struct Offsets {
  double from_m = 0, to_m = 0;
};

/// One resolution.
struct Look {
  Look(const PricedLand& land, double width_m, int count)
      : samples(count), step_m(width_m / count), ground(land, kReach_steps * step_m, kPixel_steps * step_m) {}

  int samples;
  double step_m;
  PricedGround ground;
};

class DearestPiece {
 public:
  DearestPiece(const Plan& plan, const PricedLand& land)
      : plan_(plan), land_(land), width_m_(plan.machine.width_m), groups_(obstacle_groups(plan, land.land)) {
    Box box = bounds(land.land);
    for (const Polygon& polygon : land.passable) box.extend(bounds(polygon.outer));
    pivot_ = box.centre();
    radius_m_ = 0.5 * std::hypot(box.width(), box.height());
    looks_.reserve(kLooks);
  }

  std::optional<DearPiece> run() {
    const double half_angle = kTurn_steps * width_m_ / kFirstSamples / radius_m_;
    const int directions = static_cast<int>(std::ceil(std::numbers::pi / (2 * half_angle)));
    for (int i = 0; i < directions; ++i) {
      const double half = std::numbers::pi / (2 * directions);
      if (auto dear = look(0, (2 * i + 1) * half, half, {{-radius_m_ - width_m_, radius_m_}})) return dear;
    }
    return std::nullopt;
  }

 private:
  /// Looks at the offsets of a direction and again, nearer, at those that may hold a dear piece.
  std::optional<DearPiece> look(std::size_t depth, double angle, double half_angle,
                                const std::vector<Offsets>& offsets) {
    if (looks_.size() <= depth) looks_.emplace_back(land_, width_m_, kFirstSamples << depth);
    lay(looks_[depth], angle, half_angle);
    std::vector<Offsets> open;
    std::optional<DearPiece> last;
    for (const Offsets& range : offsets) look_at(looks_[depth], range, open, last);
    if (open.empty()) return std::nullopt;
    if (depth + 1 == kLooks) return last;
    for (const int side : {-1, 1})
      if (auto dear = look(depth + 1, angle + side * 0.5 * half_angle, 0.5 * half_angle, open)) return dear;
    return std::nullopt;
  }

  void lay(const Look& look, double angle, double half_angle) {
    up_ = {std::sin(angle), std::cos(angle)};
    right_ = {up_.y, -up_.x};
    stray_m_ = radius_m_ * half_angle + look.step_m;
    rows_ = static_cast<int>(std::ceil(radius_m_ / look.step_m)) + 1;  // before and beyond the pivot
    detours_ = detours_along(plan_, groups_, pivot_, up_, stray_m_);
    prices_.clear();
    for (const DetourReach& detour : detours_) prices_.push_back(highest_price(detour.land));
  }

  double highest_price(const Box& land) const {
    double out = 0;
    for (const GroundPrices::Cell& cell : land_.prices->cells) {
      if (cell.price <= out) continue;
      Box box;
      for (const Point corner : cell.shape)
        box.extend(Point{dot(corner - pivot_, right_), dot(corner - pivot_, up_)});
      if (intersects(box, land)) out = cell.price;
    }
    return out;
  }

  void add_line(const Look& look, int line, double sign, std::vector<double>& rows) const {
    const Point foot = pivot_ + (line + 0.5) * look.step_m * right_;
    for (int i = 0; i < 2 * rows_; ++i)
      rows[static_cast<std::size_t>(i)] +=
          sign * look.ground.at(foot + (i - rows_ + 0.5) * look.step_m * up_);
  }

  void look_at(const Look& look, const Offsets& range, std::vector<Offsets>& open,
               std::optional<DearPiece>& dear) const {
    const int first = static_cast<int>(std::floor(range.from_m / look.step_m + 0.5));
    const int last = static_cast<int>(std::floor(range.to_m / look.step_m + 0.5));
    std::vector<double> rows(static_cast<std::size_t>(2 * rows_), 0);
    for (int line = first; line < first + look.samples; ++line) add_line(look, line, 1, rows);
    for (int offset = first; offset <= last; ++offset) {
      if (offset > first) {
        add_line(look, offset + look.samples - 1, 1, rows);
        add_line(look, offset - 1, -1, rows);
      }
      const double left_m = offset * look.step_m, half_m = 0.5 * look.step_m;
      const double worth = most_along(look, rows, left_m);
      if (worth <= plan_.objective.turn) continue;
      if (!open.empty() && left_m - half_m <= open.back().to_m + kTouching)
        open.back().to_m = left_m + half_m;
      else
        open.push_back({left_m - half_m, left_m + half_m});
      if (!dear || worth > dear->worth)
        dear = {pivot_ + (left_m + 0.5 * width_m_) * right_,
                Direction::clockwise_from_north(Angle::radians(std::atan2(up_.x, up_.y))), worth};
    }
  }

  /// The largest sum of consecutive rows.
  double most_along(const Look& look, const std::vector<double>& rows, double left_m) const {
    const double area_m2 = look.step_m * look.step_m, row_m2 = width_m_ * look.step_m;
    const double from_m = left_m - 0.5 * look.step_m, to_m = left_m + width_m_ + 0.5 * look.step_m;
    double most = 0, sum = 0;
    for (int i = 0; i < 2 * rows_; ++i) {
      double row = rows[static_cast<std::size_t>(i)] * area_m2;
      const double low_m = (i - rows_) * look.step_m;
      for (std::size_t k = 0; k < detours_.size(); ++k) {
        const DetourReach& detour = detours_[k];
        if (detour.left_m > to_m || detour.right_m < from_m) continue;
        if (low_m > detour.land.max_y || low_m + look.step_m < detour.land.min_y) continue;
        // Rows that a detour may replace are worth the highest price of the land that it works. All those
        // within the circle round the land count, although no track is driven where its land has ended: on a
        // small field that is some hundredths of a piece's worth too much, and it only ever refuses a proof.
        // Without obstacles there are no such rows, and those beyond the land cost as much here as anywhere.
        row = std::max(row, prices_[k] * row_m2);
      }
      for (std::size_t k = 0; k < detours_.size(); ++k)
        if (detours_[k].left_m <= to_m && detours_[k].right_m >= from_m && i == row_of(look, detours_[k]))
          row += prices_[k] * width_m_ * detours_[k].longer_m;
      sum = std::max(0.0, sum) + row;
      most = std::max(most, sum);
    }
    return most;
  }

  int row_of(const Look& look, const DetourReach& detour) const {
    const int middle =
        static_cast<int>(std::floor(0.5 * (detour.land.min_y + detour.land.max_y) / look.step_m));
    return std::clamp(middle + rows_, 0, 2 * rows_ - 1);
  }

  static constexpr double kTouching = 1e-9;

  const Plan& plan_;
  const PricedLand& land_;
  double width_m_;
  std::vector<ObstacleGroup> groups_;
  Point pivot_;
  double radius_m_ = 1;
  std::vector<Look> looks_;
  // Of the direction looked at.
  Point up_, right_;
  double stray_m_ = 0;
  int rows_ = 0;
  std::vector<DetourReach> detours_;
  std::vector<double> prices_;  ///< the highest that each detour may work
};

}  // namespace

std::optional<DearPiece> dear_piece(const Plan& plan, const PricedLand& land) {
  return DearestPiece(plan, land).run();
}

}  // namespace tramline::check
