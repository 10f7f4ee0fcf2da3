#pragma once
// The land ahead of the sections of a machine, and how the sections are to be switched, as plain values.

#include <optional>

namespace tramline::coverage {

/// The rule for switching sections. A section that is off goes on where at least `on_from` of its width needs
/// work; one that is on goes off where less than `off_below` of it does. Between the two it stays as it is.
struct SwitchRule {
  double on_from = 0.5;
  double off_below = 0.5;
  double on_latency_s = 0;   ///< from the command to the work
  double off_latency_s = 0;  ///< from the command to the end of work
  double horizon_s = 5;      ///< how far ahead to look
};

/// Throws kBadInput unless 0 < off_below ≤ on_from ≤ 1 and times are finite, not negative, and the horizon is
/// longer than the latencies.
void require_sensible(const SwitchRule& rule);

/// A switch of one section.
struct Switch {
  bool on = false;       ///< the new state
  double ahead_m = 0;    ///< distance ahead at which it takes effect
  double effect_s = 0;   ///< time from now until the section is there; not less than the latency
  double command_s = 0;  ///< time from now until the command has to be given: earlier by the latency
};

/// The kind of land that the middle of a section lies over.
enum class Over {
  kOpen,      ///< land that needs work
  kWorked,    ///< worked already
  kOutside,   ///< beyond the field
  kObstacle,  ///< in a hole of the field
};
const char* name(Over over);  ///< open, worked, outside, obstacle

/// The state of one section, now and in the near future.
struct SectionAhead {
  bool on = false;  ///< now
  double need = 0;  ///< share of its width that needs work, now
  Over over = Over::kOpen;
  std::optional<Switch> next;
  Over next_over = Over::kOpen;  ///< at the next switch
};

}  // namespace tramline::coverage
