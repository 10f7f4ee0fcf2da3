#pragma once
// A live log on its field: lines in, figures out.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "request/evaluate_input.h"
#include "tramline/coverage/live/live_coverage.h"
#include "tramline/geodesy/placed_log.h"
#include "tramline/io/log/line_log.h"

namespace tramline::app {

class WatchSession {
 public:
  /// `name`: of the log. Without a field the ground is empty.
  WatchSession(WorkGround ground, const coverage::EvaluateSettings& settings, const io::LogOptions& options,
               std::string name);
  WatchSession(const WatchSession&) = delete;
  WatchSession& operator=(const WatchSession&) = delete;

  /// Throws kBadInput where the stream is not a log, does not fit the field, or where neither the stream nor
  /// an option gives the width of the machine.
  void add(std::string_view line);
  /// The end of the stream.
  void finish();
  /// Makes the figures those of `tramline evaluate` for the lines so far. O(fixes) where they are not.
  void settle();

  const coverage::LiveCoverage& live() const { return live_; }
  std::size_t fixes() const { return live_.fixes(); }
  /// The plane of live(): the field's or, without a field, one of the log's own, which may change as long as
  /// the figures are not settled.
  const LocalFrame& frame() const { return ground_.frame; }
  /// Whether the figures are those of `tramline evaluate`.
  bool settled() const { return live_.settled() && !lines_.doubtful() && !far_from_frame(); }
  /// Whether the stream itself reports if the machine works.
  bool tells_work() const { return lines_.own_columns().work; }

  /// How the receiver came by the last position.
  io::FixQuality fix_quality() const { return lines_.quality(); }

  coverage::RepeatRule repeat_rule() const { return settings_.repeat; }

  /// The look-ahead of the sections; nullopt: not known.
  std::optional<coverage::Ahead> look_ahead(const coverage::SwitchRule& rule) const {
    return live_.look_ahead(rule);
  }
  /// Without regions and gaps, O(1).
  Coverage figures() const;
  /// With them. Precondition: settled. O(fixes and regions).
  Coverage coverage() const;

 private:
  void take(Fix fix);
  void read_anew();
  void set_frame(const WorkLog& log);
  bool far_from_frame() const;
  WorkLog head() const;
  void describe(Coverage& out) const;

  WorkGround ground_;
  coverage::EvaluateSettings settings_;
  std::string name_;
  io::LineLog lines_;
  coverage::LiveCoverage live_;
  std::optional<FixPlacing> placing_;
  SkippedRecords unplaced_;
  Box box_;  ///< of the local positions
  std::size_t next_look_ = 2;
};

}  // namespace tramline::app
