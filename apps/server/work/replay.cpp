#include "server/work/replay.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <thread>

#include "tramline/coverage/drive/working_boom.h"

namespace tramline::server {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;

/// So many fixes between two looks at the clock.
constexpr std::size_t kBetweenLooks = 64;

bool works(const Fix& fix, const coverage::PreparedLog& ready) {
  const Boom one{{1, -1}};
  const Boom& boom = fix.boom >= 0 ? ready.log.booms[static_cast<std::size_t>(fix.boom)] : one;
  return !coverage::working_boom(fix, boom, ready.drive.unknown_work).empty();
}

}  // namespace

Replay::Replay(std::shared_ptr<const ReadyDrive> drive, double from_s, double speed)
    : drive_(std::move(drive)),
      from_s_(std::isnan(from_s) ? drive_->from_s() : std::max(from_s, drive_->from_s())),
      speed_(speed),
      worked_(drive_->ground.ground, drive_->settings, drive_->ready.drive, drive_->ready.width_m,
              coverage::most_sections(drive_->ready.log.booms)),
      rate_(drive_->settings.drive.max_gap_s) {
  assert(kSlowest <= speed && speed <= kFastest);
}

void Replay::work(const Fix& fix) {
  worked_.add(fix, drive_->ready.log.booms);
  const CoverageAreas areas = worked_.areas();
  rate_.add(fix.time_s, drive_->ground.ground.empty() ? areas.covered_m2 : areas.covered_inside_m2);
  line_.push_back(worked_.position());
}

void Replay::work_until(double clock_s, Clock::time_point until) {
  const std::vector<Fix>& fixes = drive_->ready.log.fixes;
  while (driven_ < fixes.size() && drive_->clock_s[driven_] <= clock_s) {
    work(fixes[driven_]);
    if (++driven_ % kBetweenLooks == 0 && Clock::now() >= until) return;
  }
}

double Replay::due_s(Clock::time_point now) const {
  return from_s_ + speed_ * duration<double>(now - start_).count();
}

Replay::Clock::time_point Replay::due_at(double clock_s) const {
  // Nights between two days of work may last longer than the clock of the machine can count.
  const double wait_s = std::min((clock_s - from_s_) / speed_, 1e6);
  return start_ + std::chrono::ceil<Clock::duration>(duration<double>(wait_s));
}

WorkFigures Replay::figures() const {
  WorkFigures out;
  out.areas = coverage::reported(worked_.areas(), drive_->settings.repeat);
  out.has_field = !drive_->ground.ground.empty();
  out.worked_s = drive_->ready.log.clock == tramline::Clock::kNone ? std::nan("") : worked_.worked_s();
  out.present_m2_per_s = rate_.m2_per_s();
  out.meshes = worked_.engine().meshes();
  return out;
}

WorkFrame Replay::frame() {
  WorkFrame out;
  out.plane = drive_->ground.frame;
  out.fix = driven_;
  out.fixes = drive_->ready.log.fixes.size();
  out.time_s = drive_->clock_s[driven_ - 1];
  out.at = worked_.position();
  out.heading = worked_.heading();
  out.working = works(drive_->ready.log.fixes[driven_ - 1], drive_->ready);
  out.figures = figures();
  out.changes = coverage::changes_since(seen_, worked_, drive_->settings.repeat);
  out.line = out.changes.all ? thinned(line_, kEye_m) : std::move(line_);
  line_.clear();
  shown_ = driven_;
  last_frame_ = Clock::now();
  return out;
}

WorkEvent Replay::next(milliseconds most) {
  if (ended_) return {};
  const Clock::time_point deadline = Clock::now() + most;
  const std::size_t all = drive_->ready.log.fixes.size();
  if (!begun_) {
    work_until(from_s_, deadline);
    if (driven_ < all && drive_->clock_s[driven_] <= from_s_) return {};
    begun_ = true;
    start_ = Clock::now();
    return frame();
  }
  for (;;) {
    const Clock::time_point now = Clock::now(), frame_at = last_frame_ + kFrameEvery;
    work_until(due_s(now), std::max(now, frame_at) + kFrameEvery);
    if (driven_ > shown_ && Clock::now() >= frame_at) return frame();
    if (driven_ == all && shown_ == all) {
      ended_ = true;
      return WorkEnd{figures()};
    }
    const Clock::time_point next_at =
        driven_ > shown_ ? frame_at : std::max(frame_at, due_at(drive_->clock_s[driven_]));
    std::this_thread::sleep_until(std::min(next_at, deadline));
    if (next_at > deadline) return {};
  }
}

}  // namespace tramline::server
