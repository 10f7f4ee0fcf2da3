#include "server/work/live_feed.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/log/state_lines.h"

namespace tramline::server {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;

/// No fix waits longer than this for others to be shown with, and no two frames are closer together than
/// that: what is left of a tenth of a second is for making, sending and drawing the frame.
constexpr auto kLongestWait = milliseconds(50), kFrameApart = milliseconds(30);
/// So many times that fixes came are known; who reads more slowly has waited long enough.
constexpr std::size_t kTimesKept = 64;
/// Without a fix for so long, something is wrong, s.
constexpr double kStalled_s = 3;
/// States that somebody who reads late may still get.
constexpr std::size_t kStatesKept = 100;

}  // namespace

LiveFeed::LiveFeed(FeedOrder order)
    : order_(std::move(order)),
      raw_(order_.raw_log.string()),
      session_(order_.ground, order_.settings, order_.log, order_.source->name()) {
  say(fmt::format("listening to {}", order_.source->name()));
  reading_ = std::thread([this] { run(); });
  if (order_.save) saving_ = std::thread([this] { keep_saving(); });
}

void LiveFeed::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wake_.ring();
  saving_due_.notify_all();
  if (reading_.joinable()) reading_.join();
  if (saving_.joinable()) saving_.join();
}

bool LiveFeed::ended() const {
  const std::lock_guard lock(mutex_);
  return ended_;
}

std::size_t LiveFeed::fixes() const {
  const std::lock_guard lock(mutex_);
  return session_.fixes();
}

std::string LiveFeed::problem() const {
  const std::lock_guard lock(mutex_);
  return problem_;
}

/// A source that is lost has nothing to be waited on.
bool LiveFeed::connected() const { return !ended_ && order_.source->descriptor() >= 0; }

void LiveFeed::say(std::string message) {
  states_.push_back({++said_, {std::move(message), connected_}});
  if (states_.size() > kStatesKept) states_.pop_front();
  news_.notify_all();
}

void LiveFeed::set_work(bool on) {
  const std::lock_guard lock(mutex_);
  if (session_.tells_work())
    throw bad_input("the stream itself says whether the machine works, so that it cannot be switched here");
  if (session_.fixes() == 0)
    throw bad_input("work can be switched when the first position has come; wait for it");
  if (ended_) throw bad_input("the feed has ended");
  const std::string line = io::work_line(on);
  raw_.append(line + '\n');
  add(line);
}

void LiveFeed::add(const std::string& line) {
  const std::size_t before = session_.fixes();
  session_.add(line);
  const coverage::WorkedDrive* drive = session_.live().drive();
  if (drive == nullptr) return;
  if (session_.live().rebuilds() != way_of_rebuild_) {
    way_of_rebuild_ = session_.live().rebuilds();
    way_ = way_of(drive->lines());
  } else if (session_.fixes() != before) {
    way_.push_back(drive->position());
  }
}

void LiveFeed::take(io::Received received) {
  const Clock::time_point now = Clock::now();
  const std::lock_guard lock(mutex_);
  if (!received.lines.empty()) {
    std::string text;
    for (const std::string& line : received.lines) (text += line) += '\n';
    raw_.append(text);
  }
  const std::size_t before = session_.fixes();
  for (const std::string& line : received.lines) add(line);
  connected_ = connected();
  for (std::string& message : received.messages) say(std::move(message));
  if (session_.fixes() == before) return;
  last_fix_ = now;
  came_.emplace_back(session_.fixes(), now);
  if (came_.size() > kTimesKept) came_.pop_front();
  if (std::exchange(stalled_, false)) say("positions come again");
  news_.notify_all();
}

void LiveFeed::tick() {
  const std::lock_guard lock(mutex_);
  last_tick_ = Clock::now();
  raw_.retry();
  if (raw_.fault() != raw_fault_) {
    raw_fault_ = raw_.fault();
    say(raw_fault_.empty()
            ? "the log can be written again, and lacks nothing"
            : fmt::format("the log cannot be written ({}): measuring goes on; make room on the "
                          "disk",
                          raw_fault_));
  }
  if (stalled_ || duration<double>(last_tick_ - last_fix_).count() < kStalled_s) return;
  stalled_ = true;
  say(session_.fixes() == 0 ? "no position yet" : fmt::format("no position for {:g} s", kStalled_s));
}

void LiveFeed::read() {
  bool more = false, over = false;
  while (!over) {
    const int wait = order_.source->wait_ms();
    std::array<pollfd, 2> wanted{{{order_.source->descriptor(), POLLIN, 0}, {wake_.descriptor(), POLLIN, 0}}};
    poll(wanted.data(), wanted.size(), more ? 0 : wait < 0 ? 1000 : std::min(1000, wait));
    if (wanted[1].revents != 0) return;
    if (more || wanted[0].revents != 0 || wait >= 0) {
      io::Received received = order_.source->receive();
      more = received.more;
      over = received.ended;
      take(std::move(received));
    }
    if (Clock::now() - last_tick_ >= milliseconds(1000)) tick();
  }
}

void LiveFeed::run() {
  try {
    read();
  } catch (const std::exception& error) {
    const std::lock_guard lock(mutex_);
    problem_ = error.what();
  }
  finish();
}

void LiveFeed::finish() {
  const std::lock_guard lock(mutex_);
  try {
    if (const std::string rest = order_.source->rest(); problem_.empty() && !rest.empty()) {
      raw_.append(rest + '\n');
      add(rest);
    }
    session_.finish();
  } catch (const std::exception& error) {
    if (problem_.empty()) problem_ = error.what();
  }
  raw_.retry();
  ended_ = true;
  connected_ = false;
  if (!problem_.empty()) say(problem_);
  news_.notify_all();
}

void LiveFeed::keep_saving() {
  auto last = Clock::now();
  double wait_s = order_.save_every_s;
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      saving_due_.wait_until(lock, last + duration<double>(wait_s), [&] { return stopping_; });
      if (stopping_) return;
      if (session_.fixes() < 2) {
        last = Clock::now();
        continue;
      }
    }
    const auto begin = Clock::now();
    std::string fault;
    try {
      order_.save();
    } catch (const std::exception& error) {
      fault = error.what();
    }
    last = Clock::now();
    // Never more than a twentieth of the time.
    wait_s = std::max(order_.save_every_s, 20 * duration<double>(last - begin).count());
    const std::lock_guard lock(mutex_);
    if (!fault.empty()) say(fault + ": measuring goes on");
  }
}

app::LiveFigures LiveFeed::figures() const {
  const std::lock_guard lock(mutex_);
  app::LiveFigures out;
  out.evaluation.coverage = session_.figures();
  out.evaluation.repeat = session_.repeat_rule();
  out.evaluation.seconds = duration<double>(Clock::now() - start_).count();
  out.final = ended_;
  out.settled = session_.settled();
  out.present_m2_per_s = session_.live().present_m2_per_s();
  out.time_s = session_.live().last_s();
  out.working = session_.live().working();
  if (const double silent_s = duration<double>(Clock::now() - last_fix_).count();
      !ended_ && silent_s > kStalled_s)
    out.stalled_s = silent_s;
  return out;
}

WorkFigures LiveFeed::work_figures() const {
  WorkFigures out;
  out.areas = session_.live().areas();
  out.has_field = !order_.ground.ground.empty();
  const coverage::WorkedDrive* drive = session_.live().drive();
  out.worked_s = drive == nullptr || std::isnan(session_.live().last_s()) ? std::nan("") : drive->worked_s();
  out.present_m2_per_s = session_.live().present_m2_per_s();
  if (drive != nullptr) out.meshes = drive->engine().meshes();
  return out;
}

bool FeedReader::anything_new() const {
  const app::WatchSession& session = feed_->session_;
  return session.fixes() > 0 &&
         (session.fixes() != fixes_ || (seen_.any && seen_.rebuilds != session.live().rebuilds()));
}

/// When what is new is to be shown: a fix that comes alone at once, one of many with others.
FeedReader::Clock::time_point FeedReader::frame_at() const {
  const auto& came = feed_->came_;
  const auto oldest =
      std::find_if(came.begin(), came.end(), [&](const auto& time) { return time.first > fixes_; });
  const Clock::time_point latest = last_frame_ + kFrameEvery;
  if (oldest == came.end()) return latest;
  return std::clamp(oldest->second + kLongestWait, last_frame_ + kFrameApart, latest);
}

WorkFrame FeedReader::frame() {
  const app::WatchSession& session = feed_->session_;
  const coverage::LiveCoverage& live = session.live();
  WorkFrame out;
  out.plane = session.frame();
  out.fix = out.fixes = session.fixes();
  out.time_s = live.last_s();
  out.working = live.working().value_or(false);
  out.quality = name(session.fix_quality());
  out.figures = feed_->work_figures();
  out.changes = coverage::changes_since(seen_, live, session.repeat_rule());
  if (const coverage::WorkedDrive* drive = live.drive()) {
    out.at = drive->position();
    out.heading = drive->heading();
  }
  const std::vector<Point>& way = feed_->way_;
  if (out.changes.all)
    out.line = thinned(way, kEye_m);
  else
    out.line.assign(way.begin() + static_cast<std::ptrdiff_t>(std::min(places_, way.size())), way.end());
  places_ = way.size();
  fixes_ = session.fixes();
  last_frame_ = Clock::now();
  return out;
}

WorkEvent FeedReader::next(milliseconds most) {
  if (ended_) return {};
  const Clock::time_point deadline = Clock::now() + most;
  std::unique_lock lock(feed_->mutex_);
  for (;;) {
    if (!told_state_ || states_ != feed_->said_) {
      // The first is the present one, however many there were.
      const auto& states = feed_->states_;
      const auto next = std::find_if(states.begin(), states.end(),
                                     [&](const auto& state) { return state.number > states_; });
      const auto& one = told_state_ ? *next : states.back();
      told_state_ = true;
      states_ = one.number;
      return one.state;
    }
    const Clock::time_point now = Clock::now();
    if (anything_new() && (now >= frame_at() || feed_->ended_)) return frame();
    if (feed_->ended_) {
      ended_ = true;
      return WorkEnd{feed_->work_figures()};
    }
    if (now >= deadline) return {};
    feed_->news_.wait_until(lock, anything_new() ? std::min(deadline, frame_at()) : deadline);
  }
}

}  // namespace tramline::server
