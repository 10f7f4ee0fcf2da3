#include "tramline/headland/worth/worth_driving.h"

#include <algorithm>
#include <cmath>

#include "tramline/headland/path_stretch.h"
#include "tramline/headland/worth/pass_work.h"

namespace tramline {
namespace {

double worth_m2(const PassWork& work) { return kMissedToDoubled * work.fresh_m2 - work.in_vain_m2(); }

/// A short part of a path.
struct Step {
  double from_m = 0;
  double to_m = 0;
  double worth_m2 = 0;
};

std::vector<Step> steps_of(const Path& path, const GroundToWork& to_work, Swaths covered) {
  const double step_m = 0.25 * to_work.width_m;
  std::vector<Step> out;
  double at_m = 0;
  for (const PathSegment& segment : path) {
    const double length_m = length(segment);
    const int count = std::max(1, static_cast<int>(std::ceil(length_m / step_m)));
    for (int i = 0; i < count; ++i) {
      const Path part = stretch_of({segment}, length_m * i / count, length_m * (i + 1) / count);
      if (part.empty()) continue;
      out.push_back({at_m + length_m * i / count, at_m + length_m * (i + 1) / count,
                     worth_m2(work_of(part, to_work, covered))});
      covered.add(part);
    }
    at_m += length_m;
  }
  return out;
}

/// Steps first to last − 1.
struct Run {
  std::size_t first = 0;
  std::size_t last = 0;
  double sum_m2 = 0;
};

/// The run of steps of least value, which may go round the end of the list.
Run worst_run(const std::vector<Step>& steps) {
  const std::size_t n = steps.size();
  Run worst, now;
  for (std::size_t k = 0; k < 2 * n; ++k) {
    if (now.sum_m2 >= 0) now = {k, k, 0};
    now.sum_m2 += steps[k % n].worth_m2;
    now.last = k + 1;
    while (now.last - now.first > n) now.sum_m2 -= steps[now.first++ % n].worth_m2;
    if (now.sum_m2 < worst.sum_m2) worst = now;
  }
  return worst;
}

/// The steps not in a run, starting behind it: those from the beginning of the path are one length farther
/// on.
std::vector<Step> without(const Run& run, const std::vector<Step>& steps, double length_m) {
  const std::size_t n = steps.size();
  std::vector<Step> out;
  for (std::size_t k = run.last; k < run.first + n; ++k) {
    out.push_back(steps[k % n]);
    if (out.back().from_m >= out.front().from_m) continue;
    out.back().from_m += length_m;
    out.back().to_m += length_m;
  }
  return out;
}

/// The runs with the greatest total value, each less its ends.
std::vector<Run> best_runs(const std::vector<Step>& steps) {
  const std::size_t n = steps.size();
  // Best value up to a step if that is driven, and if it is not; and whether the step before was driven.
  std::vector<char> driven_before_on(n), driven_before_off(n);
  double on = -kEndsOfPass_m2, off = 0;
  for (std::size_t i = 0; i < n; ++i) {
    driven_before_on[i] = i > 0 && on >= off - kEndsOfPass_m2;
    driven_before_off[i] = i > 0 && on > off;
    const double next_off = i > 0 ? std::max(on, off) : 0;
    on = (driven_before_on[i] != 0 ? on : off - kEndsOfPass_m2) + steps[i].worth_m2;
    off = next_off;
  }
  std::vector<Run> out;
  bool driven = on > off;
  for (std::size_t i = n; i-- > 0;) {
    if (driven) {
      if (out.empty() || out.back().first != i + 1) out.push_back({i + 1, i + 1, 0});
      out.back().first = i;
    }
    driven = (driven ? driven_before_on[i] : driven_before_off[i]) != 0;
  }
  std::reverse(out.begin(), out.end());
  return out;
}

}  // namespace

std::vector<Path> worth_driving(const Path& path, const GroundToWork& to_work,
                                const std::vector<HeadlandPass>& before, double least_length_m) {
  constexpr double kNothingNew_share = 1e-3;
  const double length_m = length(path);
  const Swaths covered = swaths_of(before, to_work.width_m);
  const PassWork whole = work_of(path, to_work, covered);
  const bool closed = is_closed(path);
  if (whole.fresh_m2 < kNothingNew_share * whole.worked_m2) return {};
  if (closed && whole.in_vain_m2() < kEndsOfPass_m2) return {path};
  if (!closed && kMissedToDoubled * whole.fresh_m2 <= kEndsOfPass_m2) return {};
  std::vector<Step> steps = steps_of(path, to_work, covered);
  if (closed) {
    const Run worst = worst_run(steps);
    if (worst.sum_m2 >= -kEndsOfPass_m2 && worth_m2(whole) > 0) return {path};
    steps = without(worst, steps, length_m);
  }
  std::vector<Path> out;
  for (const Run& run : best_runs(steps)) {
    const double from_m = steps[run.first].from_m, to_m = steps[run.last - 1].to_m;
    if (to_m - from_m >= least_length_m) out.push_back(stretch_of(path, from_m, to_m));
  }
  return out;
}

double worth_m2(const std::vector<Path>& parts, const GroundToWork& to_work,
                const std::vector<HeadlandPass>& before) {
  Swaths covered = swaths_of(before, to_work.width_m);
  double out = 0;
  for (const Path& part : parts) {
    out += worth_m2(work_of(part, to_work, covered)) - (is_closed(part) ? 0 : kEndsOfPass_m2);
    covered.add(part);
  }
  return out;
}

}  // namespace tramline
