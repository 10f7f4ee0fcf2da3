#include "tramline/admission/given/place_subfields.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "tramline/admission/given/loose_land.h"
#include "tramline/admission/tolerances.h"
#include "tramline/geodesy/field_projection.h"
#include "tramline/geodesy/shown_place.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

/// From the coordinates of loose features to local metres.
class Placing {
 public:
  explicit Placing(const Field& field)
      : field_(field),
        crs_(field.frame.geodetic ? Crs("OGC:CRS84") : Crs()),
        projection_(crs_, field.frame) {}

  /// The polygons alone, without the field's outside.
  Region land(const LooseObstacle& feature) const {
    if (feature.polygons.empty()) return {};
    LooseObstacle polygons = feature;
    polygons.lines.clear();
    polygons.points.clear();
    RepairLog repair_log(feature.origin, projection_);
    return intersection(unite(land_of(polygons, 0, repair_log)), {{field_.outer, {}}});
  }

  /// Without repeated points; nullopt for a line without length or so far away that it has no place here.
  std::optional<std::vector<Point>> line(const std::vector<Point>& points) const {
    std::vector<Point> out;
    for (const Point p : points) {
      const std::optional<Point> local = projection_.to_local(p);
      if (!local) return std::nullopt;
      if (out.empty() || distance(out.back(), *local) > kSamePlace_m) out.push_back(*local);
    }
    if (out.size() < 2) return std::nullopt;
    return out;
  }

 private:
  const Field& field_;
  Crs crs_;
  FieldProjection projection_;
};

/// Land that a feature has taken.
struct PlacedLand {
  Region land;
  std::string origin;
};

class Placer {
 public:
  Placer(const Field& field, const std::vector<LooseSubfield>& all, std::vector<char>& used, GivenLand& given)
      : field_(field), all_(all), used_(used), given_(given), placing_(field) {}

  void run() {
    std::vector<LooseObstacle> features;
    for (const LooseSubfield& one : all_) features.push_back(one.feature);
    for (const std::size_t i : features_near(field_, 0, features)) {
      take(i);
      if (!all_[i].feature.lines.empty() && !is_guide(all_[i])) cut(i);
    }
  }

 private:
  bool is_guide(const LooseSubfield& line) const {
    for (const LooseSubfield& other : all_)
      if (!other.guide.empty() && other.guide == line.name) return true;
    return false;
  }

  void take(std::size_t index) {
    const LooseSubfield& drawn = all_[index];
    Region land = placing_.land(drawn.feature);
    if (area(land) <= kNoArea_m2) return;
    used_[index] = 1;
    for (const PlacedLand& before : placed_) {
      const Region common = intersection(land, before.land);
      if (area(common) <= kNoArea_m2) continue;
      remark_overlap(before.origin, drawn.feature.origin, common);
      land = difference(land, before.land);
    }
    if (area(land) <= kNoArea_m2) return;
    placed_.push_back({land, drawn.feature.origin});
    if (drawn.left_out)
      given_.left_out.insert(given_.left_out.end(), land.begin(), land.end());
    else
      given_.subfields.push_back({std::move(land), drawn.feature.origin, drawn.direction, guide_of(drawn)});
  }

  void remark_overlap(const std::string& first, const std::string& second, const Region& common) {
    constexpr double kWorthSaying_m2 = 1;
    constexpr double kDiscTolerance_m = 0.1;
    if (area(common) < kWorthSaying_m2) return;
    const Polygon* largest = &common.front();
    for (const Polygon& part : common)
      if (area(part) > area(*largest)) largest = &part;
    given_.remarks.push_back(fmt::format(
        "{} and {} overlap by {:.1f} m² at {}; the first keeps that land", first, second, area(common),
        shown_place(field_.frame, largest_disc(*largest, kDiscTolerance_m).centre)));
  }

  std::vector<Point> guide_of(const LooseSubfield& drawn) {
    if (drawn.guide.empty()) return {};
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (all_[i].feature.lines.empty() || all_[i].name != drawn.guide) continue;
      used_[i] = 1;
      if (std::optional<std::vector<Point>> line = placing_.line(all_[i].feature.lines.front())) return *line;
      throw bad_input(all_[i].feature.origin + ": the line has no length; give it two different points");
    }
    return {};
  }

  void cut(std::size_t index) {
    const Region whole{{field_.outer, {}}};
    for (const std::vector<Point>& points : all_[index].feature.lines) {
      const std::optional<std::vector<Point>> line = placing_.line(points);
      if (!line) continue;
      double inside_m = 0;
      for (std::size_t k = 0; k + 1 < line->size(); ++k)
        inside_m += length_inside(whole, (*line)[k], (*line)[k + 1]);
      if (inside_m <= 0) continue;
      used_[index] = 1;
      given_.cuts.push_back({*line, all_[index].feature.origin});
    }
  }

  const Field& field_;
  const std::vector<LooseSubfield>& all_;
  std::vector<char>& used_;
  GivenLand& given_;
  Placing placing_;
  std::vector<PlacedLand> placed_;
};

}  // namespace

void place_subfields(const Field& field, const std::vector<LooseSubfield>& subfields, std::vector<char>& used,
                     GivenLand& given) {
  Placer(field, subfields, used, given).run();
}

Region placed_land(const Field& field, const std::vector<LooseObstacle>& features, std::vector<char>& used) {
  const Placing placing(field);
  Region out;
  for (const std::size_t i : features_near(field, 0, features)) {
    Region land = placing.land(features[i]);
    if (area(land) <= kNoArea_m2) continue;
    used[i] = 1;
    out.insert(out.end(), land.begin(), land.end());
  }
  return unite(out);
}

}  // namespace tramline
