#include "tramline/headland/pass_rings.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "tramline/headland/clear_stretches.h"
#include "tramline/headland/drivable_rings.h"
#include "tramline/headland/driven_on.h"
#include "tramline/headland/edge_following_passes.h"
#include "tramline/headland/ring_groups.h"
#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

/// The input of the passes with one number.
struct Scene {
  const std::vector<Boundary>& boundaries;
  const HeadlandTerms& terms;
  int number;
  const GroundToWork& to_work;

  bool has_pass(std::size_t boundary) const { return boundaries[boundary].passes >= number; }
  double least_length_m() const { return std::max(terms.min_length_m, terms.width_m); }
};

double distance_to(const Path& path, const Ring& ring) {
  double out = std::numeric_limits<double>::infinity();
  for (const PathSegment& segment : path)
    for (std::size_t i = 0; i < ring.size(); ++i)
      out = std::min(out, distance_to_edge(segment, ring[i], ring[(i + 1) % ring.size()]));
  return out;
}

/// A pass along part of a path, with the boundaries that it follows: those it comes as near to as it might in
/// a turn, and at least the nearest that has such a pass.
HeadlandPass pass_on(const Path& path, const Scene& scene) {
  HeadlandPass out{path, scene.number, false, {}};
  const Box reach = reach_of(path, 0);
  std::size_t nearest = 0;
  double nearest_m = std::numeric_limits<double>::infinity();
  const auto name = [&](std::size_t i) {
    if (const auto obstacle = scene.boundaries[i].obstacle)
      out.obstacles.push_back(*obstacle);
    else
      out.around_field = true;
  };
  bool any = false;
  for (std::size_t i = 0; i < scene.boundaries.size(); ++i) {
    if (!scene.has_pass(i)) continue;
    const Boundary& boundary = scene.boundaries[i];
    const double near_m =
        pass_distance_m(boundary, scene.number, scene.terms.width_m) + tightest_turn_m(scene.terms);
    if (!intersects(reach.grown(2 * near_m), bounds(boundary.ring))) continue;
    const double distance_m = distance_to(path, boundary.ring);
    if (distance_m <= near_m) name(i);
    any = any || distance_m <= near_m;
    if (distance_m < nearest_m) {
      nearest_m = distance_m;
      nearest = i;
    }
  }
  if (!any) name(nearest);
  return out;
}

/// Passes chosen one after the other, in addition to those before.
class Chosen {
 public:
  Chosen(const Scene& scene, std::vector<HeadlandPass> before)
      : scene_(scene), all_(std::move(before)), first_(all_.size()) {}

  /// Adds the parts of a path that are worth driving, as passes. A ring kept as a whole keeps its names.
  void choose(const Path& path, const HeadlandPass* ring) {
    for (const Path& part : worth_driving(path, scene_.to_work, all_, scene_.least_length_m())) {
      parts_.push_back(part);
      if (ring != nullptr && part == ring->path) {
        all_.push_back(*ring);
      } else {
        all_.push_back(pass_on(part, scene_));
        all_whole_ = false;
      }
    }
  }
  /// Adds the parts worth driving of a path that was not required, if they pay.
  void choose_if_it_pays(const Path& path) {
    const std::vector<Path> parts = worth_driving(path, scene_.to_work, all_, scene_.least_length_m());
    const double parts_m2 = tramline::worth_m2(parts, scene_.to_work, all_);
    if (parts_m2 <= 0) return;
    paid_m2_ += parts_m2;  // kept, since areas take long
    for (const Path& part : parts) all_.push_back(pass_on(part, scene_));
  }
  void choose(const std::vector<HeadlandPass>& rings, const std::vector<OffsetBoundary>& in_the_way) {
    for (const HeadlandPass& ring : rings) {
      if (in_the_way.empty()) {
        choose(ring.path, &ring);
        continue;
      }
      for (const Path& stretch : clear_stretches(ring.path, in_the_way, 0.25 * scene_.terms.width_m))
        choose(stretch == ring.path ? stretch : to_the_end(stretch), &ring);
    }
  }

  /// Whether all are whole rings.
  bool all_whole() const { return all_whole_; }
  double worth_m2() const {
    return tramline::worth_m2(parts_, scene_.to_work, {all_.begin(), begin_of_own()});
  }
  /// What those chosen because they pay are worth.
  double paid_m2() const { return paid_m2_; }
  std::vector<HeadlandPass> own() const { return {begin_of_own(), all_.end()}; }
  const std::vector<HeadlandPass>& all() const { return all_; }

 private:
  std::vector<HeadlandPass>::const_iterator begin_of_own() const {
    return all_.begin() + static_cast<std::ptrdiff_t>(first_);
  }
  Path to_the_end(const Path& path) const {
    const double width_m = scene_.terms.width_m;
    std::vector<SwathLimit> limits;
    for (std::size_t i = 0; i < scene_.boundaries.size(); ++i) {
      const int before = scene_.has_pass(i) ? scene_.number - 1 : 0;
      limits.push_back({scene_.boundaries[i].ring, headland_depth_m(scene_.boundaries[i], before, width_m)});
    }
    return driven_to_the_end(path, limits, {width_m, tightest_turn_m(scene_.terms), 0.5 * width_m});
  }

  const Scene& scene_;
  std::vector<HeadlandPass> all_;
  std::size_t first_;
  std::vector<Path> parts_;
  bool all_whole_ = true;
  double paid_m2_ = 0;
};

enum class Reach { kField, kEverything };

/// Boundaries without such a pass whose distance passes have to keep: the field's, and those of all obstacles
/// where rings were made without regard to them.
std::vector<OffsetBoundary> boundaries_in_the_way(const Scene& scene, Reach reach) {
  std::vector<OffsetBoundary> out;
  const std::size_t count = reach == Reach::kField ? 1 : scene.boundaries.size();
  for (std::size_t i = 0; i < count; ++i)
    if (!scene.has_pass(i))
      out.push_back({scene.boundaries[i].ring,
                     pass_distance_m(scene.boundaries[i], scene.number, scene.terms.width_m)});
  return out;
}

/// The parts worth driving of the group's rings, or of rings round only the members with such a pass, with
/// ends at the others.
std::vector<HeadlandPass> passes_round(const RingGroup& group, const Scene& scene,
                                       const std::vector<HeadlandPass>& before) {
  Chosen together(scene, before);
  together.choose(group.passes, boundaries_in_the_way(scene, Reach::kField));
  std::vector<std::size_t> own;
  for (const std::size_t i : group.members)
    if (scene.has_pass(i)) own.push_back(i);
  if (own.size() == group.members.size() || together.all_whole()) return together.own();
  Chosen alone(scene, before);
  alone.choose(rings_round(own, scene.boundaries, scene.terms, scene.number, scene.to_work, before),
               boundaries_in_the_way(scene, Reach::kEverything));
  return alone.worth_m2() > together.worth_m2() ? alone.own() : together.own();
}

/// The passes before, and those along edges where the machine has no room to turn. Which way of driving a
/// path is better depends on what the others work: it is the first, unless all together are worth more with
/// another.
std::vector<HeadlandPass> with_passes_along_edges(const std::vector<std::vector<Path>>& paths,
                                                  const Scene& scene,
                                                  const std::vector<HeadlandPass>& before) {
  std::vector<std::size_t> ways(paths.size(), 0);
  const auto chosen = [&] {
    Chosen out(scene, before);
    for (std::size_t i = 0; i < paths.size(); ++i) out.choose_if_it_pays(paths[i][ways[i]]);
    return out;
  };
  std::optional<Chosen> best = chosen();
  for (std::size_t i = 0; i < paths.size(); ++i)
    for (std::size_t way = 1; way < paths[i].size(); ++way) {
      const std::size_t kept = std::exchange(ways[i], way);
      if (Chosen other = chosen(); other.paid_m2() > best->paid_m2() + kNoGain_m2)
        best.emplace(std::move(other));
      else
        ways[i] = kept;
    }
  return best->all();
}

/// The passes in parts that do not cross themselves: rings through narrow land may, and no machine drives
/// that.
std::vector<HeadlandPass> without_crossings(const std::vector<HeadlandPass>& passes, const Scene& scene) {
  std::vector<HeadlandPass> out;
  for (const HeadlandPass& pass : passes) {
    const std::vector<Path> parts = parted_where_it_meets_itself(pass.path);
    if (parts.size() == 1)
      out.push_back(pass);
    else
      for (const Path& part : parts)
        if (length(part) >= scene.least_length_m()) out.push_back(pass_on(part, scene));
  }
  return out;
}

}  // namespace

std::vector<HeadlandPass> pass_rings(const std::vector<Boundary>& boundaries, const HeadlandTerms& terms,
                                     int number, const GroundToWork& to_work,
                                     const std::vector<HeadlandPass>& before) {
  const Scene scene{boundaries, terms, number, to_work};
  std::vector<HeadlandPass> all = before;
  for (const RingGroup& group : ring_groups(boundaries, terms, number, to_work, before)) {
    if (group.passes.empty()) continue;
    const std::vector<HeadlandPass> more = passes_round(group, scene, all);
    all.insert(all.end(), more.begin(), more.end());
  }
  // Farther in, land left by turning is left to tracks.
  if (number == 1)
    all = with_passes_along_edges(edge_following_passes(boundaries, terms, number), scene, all);
  return without_crossings({all.begin() + static_cast<std::ptrdiff_t>(before.size()), all.end()}, scene);
}

}  // namespace tramline
