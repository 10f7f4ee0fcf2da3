#pragma once
// When a section has to be switched, so that it works what needs work and nothing else.

#include <optional>

#include "tramline/coverage/ahead/need_ahead.h"
#include "tramline/coverage/ahead/section_ahead.h"

namespace tramline::coverage {

/// What a section does now, and what was commanded and does not work yet.
struct SectionState {
  bool on = false;
  std::optional<double> turning_s;  ///< from now until it is the other way round

  bool commanded() const { return turning_s ? !on : on; }
};

/// The next switch of a section within its need; nullopt where there is none or the machine stands. It is the
/// first place, from kUnderfoot_m on, that a command can still be in time for and at which the rule asks for
/// the other state than the one commanded. O(stretches).
std::optional<Switch> next_switch(const Need& need, double speed_mps, const SectionState& state,
                                  const SwitchRule& rule);

}  // namespace tramline::coverage
