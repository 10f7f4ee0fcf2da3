#include "tramline/check/worked_body.h"

#include <utility>

#include "tramline/geometry/boolean.h"
#include "tramline/geometry/layered_area.h"
#include "tramline/geometry/path_profile.h"

namespace tramline::check {
namespace {

/// Land, ready to be laid over one polygon after another. Most are met by no edge, and need no overlay.
class Land {
 public:
  explicit Land(Region land) : land_(std::move(land)), edges_(land_), rings_(rings_of(land_)) {}

  void split(const Region& part, Region& inside, Region& beyond) const {
    for (const Polygon& polygon : part) {
      if (is_met(bounds(polygon))) {
        append(intersection({polygon}, land_), inside);
        append(difference({polygon}, land_), beyond);
      } else {
        (contains(land_, polygon.outer.front()) ? inside : beyond).push_back(polygon);
      }
    }
  }

  bool may_meet(const Polygon& polygon) const {
    return is_met(bounds(polygon)) || contains(land_, polygon.outer.front());
  }

  /// What of it matters within a window.
  void append_to(const Box& window, RisingCurves& out) const {
    if (is_met(window)) {
      for (const Ring& ring : rings_) append_ring(ring, Layer::kBody, window, out);
    } else if (contains(land_, {window.min_x, window.min_y})) {
      append_box(window, Layer::kBody, window, out);
    }
  }

 private:
  static void append(Region&& some, Region& out) {
    for (Polygon& polygon : some) out.push_back(std::move(polygon));
  }
  bool is_met(const Box& box) const {
    bool met = false;
    edges_.grid().each_meeting(box, [&met](std::size_t) { met = true; });
    return met;
  }

  Region land_;
  EdgeIndex edges_;
  std::vector<Ring> rings_;
};

void append_rings(const Polygon& polygon, Layer layer, const Box& window, RisingCurves& out) {
  append_ring(polygon.outer, layer, window, out);
  for (const Ring& hole : polygon.holes) append_ring(hole, layer, window, out);
}

/// Sweeps of more curves take longer than overlays do.
constexpr std::size_t kManyParts = 500;

}  // namespace

WorkedBody worked_on(const Region& land, const std::vector<WorkedPart>& parts, std::size_t owners,
                     double width_m) {
  const Land body(land);
  const BoxGrid grid = grid_of(parts);
  WorkedBody out;
  out.useful_m2.assign(owners, 0);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Region useful, before;
    body.split(parts[i].ground, useful, out.beyond);
    grid.each_meeting(bounds(parts[i].ground), [&](std::size_t k) {
      if (k < i && may_meet(parts[k], parts[i], width_m))
        before.insert(before.end(), parts[k].ground.begin(), parts[k].ground.end());
    });
    if (!before.empty()) useful = difference(unite(useful), unite(before));
    out.useful_m2[parts[i].piece] += area(useful);
  }
  for (const double useful_m2 : out.useful_m2) out.covered_m2 += useful_m2;
  return out;
}

double left_within_m2(const Region& layer, const Region& body, const std::vector<WorkedPart>& parts) {
  const Land ready(body);
  const BoxGrid grid = grid_of(parts);
  double sum = 0;
  for (const Polygon& polygon : layer) {
    const Box window = bounds(polygon);
    std::vector<std::size_t> near_by;
    grid.each_meeting(window, [&near_by](std::size_t i) { near_by.push_back(i); });
    if (near_by.size() > kManyParts) {
      const Land within({polygon});
      Region worked;
      for (const std::size_t i : near_by)
        for (const Polygon& part : parts[i].ground)
          if (within.may_meet(part)) worked.push_back(part);
      sum += area(difference(intersection({polygon}, body), unite(worked)));
      continue;
    }
    RisingCurves curves;
    append_rings(polygon, Layer::kNew, window, curves);
    ready.append_to(window, curves);
    for (const std::size_t i : near_by)
      for (const Polygon& part : parts[i].ground) append_rings(part, Layer::kTaken, window, curves);
    sum += new_area(curves);
  }
  return sum;
}

}  // namespace tramline::check
