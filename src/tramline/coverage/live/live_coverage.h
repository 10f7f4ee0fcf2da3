#pragma once
// The evaluation of a drive while it goes on.

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tramline/coverage/ahead/look_ahead.h"
#include "tramline/coverage/drive/log_sanity.h"
#include "tramline/coverage/drive/worked_drive.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/coverage/live/work_rate.h"
#include "tramline/model/coverage.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

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

  /// `booms`: of the log so far; those of before stay. Amortised O(quads of the fix); O(fixes) where the
  /// judgement changes. Precondition: position local.
  void add(const Fix& fix, std::span<const Boom> booms);
  /// Works all fixes anew where any was taken out of order. O(fixes) then.
  void settle();
  bool settled() const { return !owed_; }
  /// This log instead of all that came so far. O(fixes).
  void restart(WorkLog log);

  std::size_t fixes() const { return log_.fixes.size(); }
  /// The work itself; nullptr before a width is known. Another one after every rebuild.
  const WorkedDrive* drive() const { return drive_ ? &*drive_ : nullptr; }
  /// How often all fixes were worked anew.
  std::size_t rebuilds() const { return rebuilds_; }
  /// Current, with slivers as repeated where that was asked for.
  CoverageAreas areas() const;
  /// Ground gained of the field (without one, anywhere) by the time driven lately, m²/s; NaN: not known.
  double present_m2_per_s() const { return rate_.m2_per_s(); }
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
  bool judge(const Fix& fix);
  void take_booms(std::span<const Boom> booms);
  Fix mended_fix(Fix fix) const;
  /// Where nothing is said of the work, all of it counts; where something is, only what is said.
  WorkState unknown_work() const { return says_work_ ? WorkState::kOff : WorkState::kOn; }
  void work(const Fix& fix);
  void rebuild();

  const Region* field_;
  EvaluateSettings settings_;
  WorkLog log_;                ///< as it came
  std::vector<Boom> booms_;    ///< mended
  std::vector<char> changed_;  ///< of them
  double width_m_;

  SectionTrust trust_;
  bool says_work_ = false;
  std::map<int, double> latest_s_;  ///< of each unit
  double last_key_s_;               ///< time of the last fix that had one
  double front_key_s_;              ///< latest of all
  bool disordered_ = false;
  std::size_t late_ = 0;
  bool owed_ = false;
  std::size_t since_rebuild_ = 0;
  std::size_t rebuilds_ = 0;

  std::optional<WorkedDrive> drive_;  ///< none before a width is known
  WorkRate rate_;
};

}  // namespace tramline::coverage
