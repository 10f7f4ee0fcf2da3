#include "tramline/coverage/ahead/section_switch.h"

#include <algorithm>
#include <cmath>

#include "tramline/geometry/error.h"

namespace tramline::coverage {
namespace {

/// Shares this close are equal: a whole section's is 1 but for rounding.
constexpr double kSameShare = 1e-9;

bool asks_for_change(double share, bool on, const SwitchRule& rule) {
  return on ? share < rule.off_below - kSameShare : share >= rule.on_from - kSameShare;
}

/// The first place of a stretch from `from_m` on at which the rule asks for the other state.
std::optional<double> change_in(const NeedStretch& stretch, double from_m, bool on, const SwitchRule& rule) {
  const double first = std::max(stretch.from_m, from_m);
  if (first >= stretch.to_m) return std::nullopt;
  const double before = stretch.at(first);
  if (asks_for_change(before, on, rule)) return first;
  if (!asks_for_change(stretch.share_to, on, rule)) return std::nullopt;
  const double level = on ? rule.off_below : rule.on_from;
  const double part = std::clamp((level - before) / (stretch.share_to - before), 0.0, 1.0);
  return first + part * (stretch.to_m - first);
}

bool is_time(double seconds) { return std::isfinite(seconds) && seconds >= 0; }

}  // namespace

void require_sensible(const SwitchRule& rule) {
  if (!(rule.off_below > 0 && rule.off_below <= rule.on_from && rule.on_from <= 1))
    throw bad_input(
        "the share from which a section is switched on must not be smaller than the one below which it is "
        "switched off, and both must lie between 0 and 1");
  if (!is_time(rule.on_latency_s) || !is_time(rule.off_latency_s) || !is_time(rule.horizon_s) ||
      rule.horizon_s <= std::max(rule.on_latency_s, rule.off_latency_s))
    throw bad_input("latencies must not be negative, and the horizon must be longer than either of them");
}

std::optional<Switch> next_switch(const Need& need, double speed_mps, const SectionState& state,
                                  const SwitchRule& rule) {
  if (!(speed_mps > 0)) return std::nullopt;
  const bool on = state.commanded();
  const double latency_s = on ? rule.off_latency_s : rule.on_latency_s;
  const double from_m = std::max(kUnderfoot_m, speed_mps * std::max(latency_s, state.turning_s.value_or(0)));
  for (const NeedStretch& stretch : need)
    if (const std::optional<double> position = change_in(stretch, from_m, on, rule)) {
      const double effect_s = *position / speed_mps;
      return Switch{!on, *position, effect_s, std::max(0.0, effect_s - latency_s)};
    }
  return std::nullopt;
}

}  // namespace tramline::coverage
