#pragma once
// The time at which a section has to be switched, so that it works the land that needs work and nothing else.

#include <optional>

#include "tramline/coverage/ahead/need_ahead.h"
#include "tramline/coverage/ahead/section_ahead.h"

namespace tramline::coverage {

/// The present state of a section, with a command that has not taken effect yet, if any.
struct SectionState {
  bool on = false;
  std::optional<double> turning_s;  ///< time from now until the state changes

  bool commanded() const { return turning_s ? !on : on; }
};

/// The next switch of a section within its need; nullopt where there is none or the machine stands. It is at
/// the first position, from kUnderfoot_m on, that a command can still reach in time and at which the rule
/// asks for a state other than the commanded one. O(stretches).
std::optional<Switch> next_switch(const Need& need, double speed_mps, const SectionState& state,
                                  const SwitchRule& rule);

}  // namespace tramline::coverage
