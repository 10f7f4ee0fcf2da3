#pragma once
// The evaluation of a drive while it goes on.

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

/// A boom and what each of its sections comes to.
struct Ahead {
  Boom boom;
  std::vector<SectionAhead> sections;
};

/// Takes fixes one by one; areas are current after every one, and once settle()d those of evaluate() on the
/// same log.
///
/// Some rules of evaluate() look at the whole log. The drive is judged by what is known so far, all fixes are
/// kept, and where a later one changes the judgement, they are worked anew:
/// - at once when the log turns out to say whether the machine works, when states of sections are found not
/// to
///   be states, or to be some after all, and when the first width comes: a few times in all;
/// - for fixes out of order of time when the log has grown by an eighth since the last time, so that a fix
///   costs nine times its own work at most, however many are late. Until then they are taken as they come.
/// Only the side of the engine's tiles, which is that of the width known first, may differ from evaluate()'s.
class LiveCoverage {
 public:
  /// `field`: as in evaluate(); it has to outlive this. settings.slice and threads are not used.
  LiveCoverage(const Region& field, const EvaluateSettings& settings);
  LiveCoverage(Region&& gone, const EvaluateSettings& settings) = delete;
  LiveCoverage(LiveCoverage&& other) noexcept;
  LiveCoverage& operator=(LiveCoverage&& other) noexcept;
  ~LiveCoverage();

  /// `booms`: of the log so far; those of before stay. Amortised O(quads of the fix); O(fixes) where the
  /// judgement changes. Precondition: position local.
  void add(const Fix& fix, std::span<const Boom> booms);
  /// Works all fixes anew where any was taken out of order. O(fixes) then.
  void settle();
  bool settled() const;
  /// This log instead of all that came so far. O(fixes).
  void restart(WorkLog log);

  std::size_t fixes() const;
  /// The work itself; nullptr before a width is known. Another one after every rebuild.
  const WorkedDrive* drive() const;
  /// How often all fixes were worked anew.
  std::size_t rebuilds() const;
  /// Current, with slivers as repeated where that was asked for.
  CoverageAreas areas() const;
  /// Ground gained of the field (without one, anywhere) by the time driven lately, m²/s; NaN: not known.
  double present_m2_per_s() const;
  /// At work at the last fix; nullopt before the first.
  std::optional<bool> working() const;
  /// Of the last fix; NaN: none.
  double last_s() const;
  /// What the sections of the last fix come to, as they work there; a machine without sections is one.
  /// nullopt where width, heading or speed are not known, and with another engine than the exact one.
  /// Precondition: sensible rule. O(c log c) for the c cells ahead.
  std::optional<Ahead> look_ahead(const SwitchRule& rule) const;

  /// Figures without regions and gaps. Name, clock, skipped records and notes are the log's, of which
  /// `head` has no fixes. O(1).
  Coverage figures(const WorkLog& head) const;
  /// What evaluate() gives for the same log, missed ground, gaps and shapes too. O(fixes and regions).
  /// Precondition: settled.
  Coverage coverage(const WorkLog& head) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tramline::coverage
