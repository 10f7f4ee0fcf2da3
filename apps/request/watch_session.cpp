#include "request/watch_session.h"

#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

/// Up to here areas in a frame of one's own are those in any other, to a millionth, m.
constexpr double kFrameHolds_m = 2000;

}  // namespace

WatchSession::WatchSession(WorkGround ground, const coverage::EvaluateSettings& settings,
                           const io::LogOptions& options, std::string name)
    : ground_(std::move(ground)),
      settings_(settings),
      name_(std::move(name)),
      lines_(options, name_),
      live_(ground_.ground, settings_) {}

void WatchSession::set_frame(const WorkLog& log) {
  if (ground_.ground.empty()) ground_.frame = frame_centred_on(log);
  placing_.emplace(log.positions, ground_.frame, name_);
}

void WatchSession::take(Fix fix) {
  if (std::isnan(settings_.drive.width_m) && fix.boom < 0 && fixes() == 0 && !lines_.own_columns().width)
    throw bad_input(name_ + " does not say how wide the machine works: give --width");
  if (!placing_) {
    WorkLog first;
    first.name = name_;
    first.positions = lines_.positions();
    first.fixes = {fix};
    set_frame(first);
  }
  std::string why;
  const std::optional<Point> local = (*placing_)(fix.position, why);
  if (!local) return unplaced_.add(fix.record, std::move(why));
  fix.position = *local;
  box_.extend(*local);
  live_.add(fix, lines_.booms());
}

void WatchSession::add(std::string_view line) {
  for (const Fix& fix : lines_.add(line)) take(fix);
  const bool look = lines_.doubtful() && fixes() >= next_look_;
  if (!look && !lines_.urgent()) return;
  read_anew();
  next_look_ = 2 * fixes();
}

void WatchSession::finish() {
  for (const Fix& fix : lines_.finish()) take(fix);
  settle();
}

void WatchSession::settle() {
  if (lines_.doubtful() || far_from_frame()) read_anew();
  live_.settle();
}

bool WatchSession::far_from_frame() const {
  return ground_.ground.empty() && !box_.empty() && length(box_.centre()) > kFrameHolds_m;
}

void WatchSession::read_anew() {
  WorkLog log = lines_.settle();
  log.name = name_;
  unplaced_ = {};
  box_ = {};
  if (log.fixes.empty()) return live_.restart({});
  set_frame(log);
  log = placed(std::move(log), ground_.frame);
  for (const Fix& fix : log.fixes) box_.extend(fix.position);
  const SkippedRecords read = lines_.head().skipped;
  unplaced_.count = log.skipped.count - read.count;
  for (std::size_t i = read.listed.size(); i < log.skipped.listed.size(); ++i)
    unplaced_.listed.push_back(log.skipped.listed[i]);
  live_.restart(std::move(log));
}

WorkLog WatchSession::head() const {
  WorkLog out = lines_.head();
  out.name = name_;
  out.skipped.add(unplaced_);
  return out;
}

void WatchSession::describe(Coverage& out) const {
  out.field_id = ground_.field_id;
  out.field = ground_.ground;
  out.frame = ground_.frame;
}

Coverage WatchSession::figures() const {
  Coverage out = live_.figures(head());
  describe(out);
  return out;
}

Coverage WatchSession::coverage() const {
  assert(settled());
  Coverage out = live_.coverage(head());
  describe(out);
  return out;
}

}  // namespace tramline::app
