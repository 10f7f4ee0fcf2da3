#pragma once
// The live evaluation of a drive in progress.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "tramline/coverage/ahead/section_ahead.h"
#include "tramline/coverage/evaluate_settings.h"
#include "tramline/model/coverage.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

class WorkedDrive;

/// A boom with the look-ahead of each of its sections.
struct Ahead {
  Boom boom;
  std::vector<SectionAhead> sections;
};

/// Evaluates fixes one by one. Areas are current after every fix and, after settle(), equal those of
/// evaluate() on the same log.
/// Some rules of evaluate() depend on the whole log. They are applied to the fixes so far; all fixes are
/// kept, and where a later one changes the outcome of a rule, they are evaluated again:
/// - at once when the log turns out to say whether the machine works, when states of sections are found not
/// to
///   be states, or to be some after all, and when the first width comes: a few times in all;
/// - for fixes out of order of time when the log has grown by an eighth since the last time, so that a fix
/// costs nine times its own work at most, however many are late. Until then they are evaluated as they come.
/// Only the side of the engine's tiles, which follows from the first known width, may differ from that in
/// evaluate().
class LiveCoverage {
 public:
  /// `field`: as in evaluate(); it has to outlive this. settings.slice and threads are not used.
  LiveCoverage(const Region& field, const EvaluateSettings& settings);
  LiveCoverage(Region&& gone, const EvaluateSettings& settings) = delete;
  LiveCoverage(LiveCoverage&& other) noexcept;
  LiveCoverage& operator=(LiveCoverage&& other) noexcept;
  ~LiveCoverage();

  /// `booms`: those of the log so far; earlier ones stay. Amortised O(quads of the fix); O(fixes) where all
  /// are evaluated again. Precondition: position local.
  void add(const Fix& fix, std::span<const Boom> booms);
  /// Evaluates all fixes again if any was processed out of order. O(fixes) then.
  void settle();
  bool settled() const;
  /// Replaces all fixes so far by this log. O(fixes).
  void restart(WorkLog log);

  std::size_t fixes() const;
  /// The underlying drive; nullptr before a width is known. A new object after every rebuild.
  const WorkedDrive* drive() const;
  /// How often all fixes were evaluated again.
  std::size_t rebuilds() const;
  /// The current areas; slivers count as repeated if the settings say so.
  CoverageAreas areas() const;
  /// The recent rate of newly covered land of the field (without a field, anywhere) per time driven, m²/s;
  /// NaN: not known.
  double present_m2_per_s() const;
  /// Whether the machine was at work at the last fix; nullopt before the first.
  std::optional<bool> working() const;
  /// The time of the last fix; NaN: none.
  double last_s() const;
  /// The look-ahead of the sections that work at the last fix; a machine without sections counts as one
  /// section. nullopt where width, heading or speed are not known, and with another engine than the exact
  /// one. Precondition: sensible rule. O(c log c) for the c cells ahead.
  std::optional<Ahead> look_ahead(const SwitchRule& rule) const;

  /// The figures without regions and gaps. Name, clock, skipped records and notes come from `head`, the log
  /// without its fixes. O(1).
  Coverage figures(const WorkLog& head) const;
  /// The result of evaluate() for the same log, including missed land, gaps and shapes. O(fixes and regions).
  /// Precondition: settled.
  Coverage coverage(const WorkLog& head) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tramline::coverage
