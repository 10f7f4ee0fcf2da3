#include "tramline/geometry/profile/section_slabs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tramline/geometry/profile/section_parts.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

class SlabsMaker {
 public:
  SlabsMaker(const SegmentFrame& frame, double width, RightEnds right, SegmentProfile& out)
      : frame_(frame), width_(width), right_(std::move(right)), out_(out) {}

  void add(const EdgeIndex& region, SectionBefore& before) {
    std::sort(right_.crossings.begin(), right_.crossings.end(),
              [](const RightCrossing& a, const RightCrossing& b) { return a.along < b.along; });
    make_slabs();
    set_states(before.right_inside);
    // An edge beside the right ends may cross them at different positions in the frames of one segment and
    // the next: then the length inside jumps, as it may where an edge lies along a cross-section.
    if (right_.near_start || before.right_inside < 0 ||
        std::abs(inside_at(out_.slabs.front(), 0) - before.inside_m) > kSamePlace_m)
      set_states(state_at_start(region));
    before.right_inside = right_.near_end ? -1 : out_.slabs.back().right_inside;
    before.inside_m = inside_at(out_.slabs.back(), out_.length);
  }

 private:
  void make_slabs() {
    if (out_.parts.empty() && right_.crossings.empty()) {
      out_.slabs.push_back({0, out_.length});
      return;
    }
    std::vector<double> cuts{0, out_.length};
    for (const SectionPart& part : out_.parts) {
      cuts.push_back(part.from);
      cuts.push_back(part.to);
    }
    for (const RightCrossing& crossing : right_.crossings) cuts.push_back(crossing.along);
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      SectionSlab slab{cuts[i], cuts[i + 1]};
      for (std::size_t p = 0; p < out_.parts.size(); ++p)
        if (out_.parts[p].from <= slab.from && out_.parts[p].to >= slab.to) slab.parts.push_back(p);
      out_.slabs.push_back(std::move(slab));
    }
  }

  void set_states(int at_start) {
    int state = at_start;
    auto crossing = right_.crossings.begin();
    for (SectionSlab& slab : out_.slabs) {
      for (; crossing != right_.crossings.end() && crossing->along <= slab.from; ++crossing)
        state += crossing->change;
      slab.right_inside = state;
    }
  }

  double inside_at(const SectionSlab& slab, double along) const {
    double sum = slab.right_inside * width_;
    for (const std::size_t p : slab.parts)
      sum += out_.parts[p].sign * across_at(out_, 0.5 * width_, out_.parts[p], along);
    return sum;
  }

  /// Tests the middle of the widest gap between edges in the longest slab, and goes back from there.
  int state_at_start(const EdgeIndex& region) const {
    const auto longest = std::max_element(
        out_.slabs.begin(), out_.slabs.end(),
        [](const SectionSlab& a, const SectionSlab& b) { return a.to - a.from < b.to - b.from; });
    const double along = 0.5 * (longest->from + longest->to);
    std::vector<std::pair<double, int>> met{{0, 0}, {width_, 0}};
    for (const std::size_t p : longest->parts)
      met.emplace_back(across_at(out_, 0.5 * width_, out_.parts[p], along), out_.parts[p].sign);
    std::sort(met.begin(), met.end());
    std::size_t widest = 0;
    for (std::size_t i = 0; i + 1 < met.size(); ++i)
      if (met[i + 1].first - met[i].first > met[widest + 1].first - met[widest].first) widest = i;
    const Point asked = frame_.point_at(along, 0.5 * (met[widest].first + met[widest + 1].first));
    int state = region.contains(asked) ? 1 : 0;
    for (std::size_t i = widest + 1; i < met.size(); ++i) state -= met[i].second;
    for (const RightCrossing& crossing : right_.crossings)
      if (crossing.along <= longest->from) state -= crossing.change;
    return state;
  }

  const SegmentFrame& frame_;
  double width_;
  RightEnds right_;
  SegmentProfile& out_;
};

}  // namespace

void add_section_slabs(const EdgeIndex& region, const SegmentFrame& frame, double width_m, RightEnds right,
                       SectionBefore& before, SegmentProfile& out) {
  SlabsMaker(frame, width_m, std::move(right), out).add(region, before);
}

}  // namespace tramline
