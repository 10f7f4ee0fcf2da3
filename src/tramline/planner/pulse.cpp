#include "tramline/planner/pulse.h"

#include <chrono>

namespace tramline {
namespace {

thread_local Pulse* pulse_of_this_thread = nullptr;

constexpr std::int64_t kBetween_ns = 20'000'000;

std::int64_t now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

Pulse::Pulse(const Progress& progress) : progress_(progress), outer_(pulse_of_this_thread) {
  // Without a progress of its own a search beats for the one around it.
  if (progress_) pulse_of_this_thread = this;
}

Pulse::~Pulse() {
  if (progress_) pulse_of_this_thread = outer_;
}

Progress Pulse::counter() {
  if (!progress_) return {};
  return [this](int done, int total) { return count(done, total); };
}

Demand Pulse::count(int done, int total) {
  const std::lock_guard lock(mutex_);
  done_ = done;
  total_ = total;
  call();
  return ending_ ? Demand::kEnd : Demand::kGoOn;
}

void Pulse::call() {
  if (progress_(done_, total_) == Demand::kEnd) ending_ = true;
}

void Pulse::call_if_due() {
  const std::int64_t now = now_ns();
  if (now < due_ns_.load(std::memory_order_relaxed)) return;
  const std::lock_guard lock(mutex_);
  if (now < due_ns_.load(std::memory_order_relaxed)) return;
  // Left as it is by a progress that throws: all others are to stop as well.
  call();
  due_ns_.store(now + kBetween_ns, std::memory_order_relaxed);
}

void beat() {
  if (pulse_of_this_thread != nullptr) pulse_of_this_thread->call_if_due();
}

bool has_to_end() {
  Pulse* pulse = pulse_of_this_thread;
  if (pulse == nullptr) return false;
  pulse->call_if_due();
  if (!pulse->ending_) return false;
  pulse->cut_short_ = true;
  return true;
}

PulseOfThread::PulseOfThread() : pulse_(pulse_of_this_thread) {}

PulseOfThread::Borrowed::Borrowed(const PulseOfThread& lender) : before_(pulse_of_this_thread) {
  pulse_of_this_thread = lender.pulse_;
}

PulseOfThread::Borrowed::~Borrowed() { pulse_of_this_thread = before_; }

}  // namespace tramline
