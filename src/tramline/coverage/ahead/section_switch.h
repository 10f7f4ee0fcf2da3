#pragma once
// When a section has to be switched, so that it works what needs work and nothing else.

#include <optional>

#include "tramline/coverage/ahead/need_ahead.h"

namespace tramline::coverage {

/// How sections are switched. A section that is off goes on where at least `on_from` of its width needs work;
/// one that is on goes off where less than `off_below` of it does. Between the two it stays as it is.
struct SwitchRule {
  double on_from = 0.5;
  double off_below = 0.5;
  double on_latency_s = 0;   ///< from the command to the work
  double off_latency_s = 0;  ///< from the command to its end
  double horizon_s = 5;      ///< how far ahead to look
};

/// Throws kBadInput unless 0 < off_below ≤ on_from ≤ 1 and times are finite, not negative, and the horizon is
/// longer than the latencies.
void require_sensible(const SwitchRule& rule);

/// What a section does now, and what was commanded and does not work yet.
struct SectionState {
  bool on = false;
  std::optional<double> turning_s;  ///< from now until it is the other way round

  bool commanded() const { return turning_s ? !on : on; }
};

/// A section to be switched.
struct Switch {
  bool on = false;       ///< what to
  double ahead_m = 0;    ///< where
  double effect_s = 0;   ///< from now until it is there; not before a command given now works
  double command_s = 0;  ///< from now until the command has to be given: earlier by the latency
};

/// The next switch of a section within its need; nullopt where there is none or the machine stands. It is the
/// first place, from kUnderfoot_m on, that a command can still be in time for and at which the rule asks for
/// the other state than the one commanded. O(stretches).
std::optional<Switch> next_switch(const Need& need, double speed_mps, const SectionState& state,
                                  const SwitchRule& rule);

}  // namespace tramline::coverage
