#pragma once
// What logs say of a machine that cannot be meant so.

#include <optional>

#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// No machine is wider, m.
inline constexpr double kWidestMachine_m = 60;

/// The note on what mends the second of the faults below.
inline constexpr const char* kSectionsIgnored =
    "no section ever works, although the machine does: the states of sections are ignored";

/// The log, with two faults mended that make it worthless otherwise, and noted:
/// - widths of elements side by side that add up to more than kWidestMachine_m are copies of one: such a boom
/// becomes one
///   section as wide as its widest;
/// - states of sections of which none ever works although the machine says that it does are no states.
/// O(fixes).
WorkLog log_without_faults(WorkLog log);

/// The boom that is meant by one whose widths add up to more than kWidestMachine_m; nullopt for any other.
std::optional<Boom> mended(const Boom& boom);
/// A fix of such a boom: its one section works where any did.
Fix with_one_section(Fix fix);

/// Whether states of sections are states, told fix by fix.
class SectionTrust {
 public:
  void add(const Fix& fix);
  /// Whether those so far are to be ignored: none ever works although the machine says that it does.
  bool ignored() const { return says_ && !works_; }

 private:
  bool says_ = false;
  bool works_ = false;
};

}  // namespace tramline::coverage
