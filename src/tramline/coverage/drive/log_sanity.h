#pragma once
// Repairs logs whose data on the machine cannot be right.

#include <optional>

#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// The greatest plausible width of a machine, m.
inline constexpr double kWidestMachine_m = 60;

/// The note on the repair of the second fault below.
inline constexpr const char* kSectionsIgnored =
    "no section ever works, although the machine does: the states of sections are ignored";

/// The log after repair of two faults that would make it worthless; repairs are noted:
/// - widths of elements side by side that add up to more than kWidestMachine_m are copies of one: such a boom
/// becomes one
///   section as wide as its widest;
/// - states of sections of which none ever works although the machine says that it does are no states.
/// O(fixes).
WorkLog log_without_faults(WorkLog log);

/// The repaired boom for one whose widths add up to more than kWidestMachine_m; nullopt for any other boom.
std::optional<Boom> mended(const Boom& boom);
/// A fix converted to such a repaired boom: its one section works where any section did.
Fix with_one_section(Fix fix);

/// Determines fix by fix whether the states of sections can be trusted.
class SectionTrust {
 public:
  void add(const Fix& fix);
  /// Whether the states so far are to be ignored: no section ever works although the machine reports that it
  /// does.
  bool ignored() const { return says_ && !works_; }

 private:
  bool says_ = false;
  bool works_ = false;
};

}  // namespace tramline::coverage
