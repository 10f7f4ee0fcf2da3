#include "tramline/route/build/work_by_part.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/outline_distance.h"
#include "tramline/route/axle/axle_path.h"

namespace tramline {
namespace {

/// Land that is narrower than the outline by twice this is held for wide enough, m.
constexpr double kNarrower_m = 0.05;

/// Where the axle may be, in parts that do not meet.
Region places_of_axle(const DrivingGround& ground) {
  const double aside_m = half_breadth_m(ground.outline()) - kNarrower_m;
  return aside_m > 0 ? buffered(ground.land().land(), -aside_m) : ground.land().land();
}

Point middle_of(const SteeredPath& path) { return pose_on(path, 0.5 * length(path)).at; }

double distance_to(const Polygon& part, Point p) {
  return contains(part, p) ? 0 : distance_to_outline(p, part);
}

std::size_t nearest_part(const Region& parts, Point p) {
  std::size_t out = 0;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < parts.size() && least_m > 0; ++i) {
    const double off_m = distance_to(parts[i], p);
    if (off_m >= least_m) continue;
    least_m = off_m;
    out = i;
  }
  return out;
}

struct Part {
  Polygon places;
  PartWork work{};
  double work_m = 0;
};

/// Those with work.
std::vector<Part> parts_with_work(const Region& places, const std::vector<RouteLine>& lines,
                                  const Headland& headland) {
  std::vector<Part> out;
  for (const Polygon& part : places) out.push_back({part});
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const SteeredPath& axle = lines[i].senses.front().first;
    Part& part = out[nearest_part(places, middle_of(axle))];
    part.work.lines.push_back(i);
    part.work_m += length(axle);
  }
  for (std::size_t i = 0; i < headland.passes.size(); ++i) {
    const SteeredPath axle = steered(headland.passes[i].path);
    Part& part = out[nearest_part(places, middle_of(axle))];
    part.work.passes.push_back(i);
    part.work_m += length(axle);
  }
  std::erase_if(out, [](const Part& part) { return part.work_m == 0; });
  return out;
}

std::size_t nearest_to(Point gate, const std::vector<Part>& parts) {
  Region places;
  for (const Part& part : parts) places.push_back(part.places);
  return nearest_part(places, gate);
}

std::size_t most_work(const std::vector<Part>& parts) {
  const auto most = std::ranges::max_element(parts, {}, &Part::work_m);
  return static_cast<std::size_t>(most - parts.begin());
}

std::size_t nearest_to(const Polygon& places, const std::vector<Part>& parts) {
  std::size_t out = 0;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double apart_m = distance_between({places}, {parts[i].places});
    if (apart_m >= least_m) continue;
    least_m = apart_m;
    out = i;
  }
  return out;
}

Point nearest_corner(const Polygon& of, const Polygon& to) {
  return *std::ranges::min_element(of.outer, {}, [&](Point corner) { return distance_to(to, corner); });
}

/// Takes one out of a list.
Part taken(std::vector<Part>& parts, std::size_t i) {
  Part out = std::move(parts[i]);
  parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
  return out;
}

std::vector<PartWork> in_driving_order(std::vector<Part> parts, const RouteEnds& ends) {
  std::optional<Part> first, last;
  if (ends.start) first = taken(parts, nearest_to(*ends.start, parts));
  if (ends.end && !parts.empty()) last = taken(parts, nearest_to(*ends.end, parts));
  if (!first && !parts.empty()) first = taken(parts, most_work(parts));
  if (!first) std::swap(first, last);
  std::vector<Part> out{std::move(*first)};
  while (!parts.empty()) out.push_back(taken(parts, nearest_to(out.back().places, parts)));
  if (last) out.push_back(std::move(*last));
  std::vector<PartWork> work;
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (i + 1 < out.size()) out[i].work.next = nearest_corner(out[i + 1].places, out[i].places);
    work.push_back(std::move(out[i].work));
  }
  return work;
}

PartWork all_work(const std::vector<RouteLine>& lines, const Headland& headland) {
  PartWork out;
  for (std::size_t i = 0; i < lines.size(); ++i) out.lines.push_back(i);
  for (std::size_t i = 0; i < headland.passes.size(); ++i) out.passes.push_back(i);
  return out;
}

}  // namespace

std::vector<PartWork> work_by_part(const std::vector<RouteLine>& lines, const Headland& headland,
                                   const RouteEnds& ends, const DrivingGround& ground) {
  const bool sharp = headland.construction != HeadlandConstruction::kDrivable;
  const Region places = sharp ? Region{} : places_of_axle(ground);
  if (places.size() < 2) return {all_work(lines, headland)};
  return in_driving_order(parts_with_work(places, lines, headland), ends);
}

}  // namespace tramline
