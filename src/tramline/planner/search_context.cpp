#include "tramline/planner/search_context.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <utility>

namespace tramline {
namespace {

constexpr std::int64_t kBetweenReports_ns = 20'000'000;
constexpr int kThousandths = 1000;

std::int64_t now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

/// The callback of a search, with the counts it last received and its last answer.
class SearchContext::SharedProgress {
 public:
  explicit SharedProgress(Progress progress) : progress_(std::move(progress)) {}

  void count(int done, int total) {
    const std::lock_guard lock(mutex_);
    done_ = done;
    total_ = total;
    call();
  }

  /// In thousandths of the whole, of which none is taken back.
  void reach(double share) {
    const std::lock_guard lock(mutex_);
    const int before = total_ == kThousandths ? done_ : 0;
    done_ = std::max(before, static_cast<int>(share * kThousandths));
    total_ = kThousandths;
    call();
  }

  void report() {
    const std::int64_t now = now_ns();
    if (now < due_ns_.load(std::memory_order_relaxed)) return;
    const std::lock_guard lock(mutex_);
    if (now < due_ns_.load(std::memory_order_relaxed)) return;
    // Stays due where the progress throws: all other threads are to stop as well.
    call();
    due_ns_.store(now + kBetweenReports_ns, std::memory_order_relaxed);
  }

  bool has_to_end() {
    report();
    if (!ending_) return false;
    cut_short_ = true;
    return true;
  }

  bool cut_short() const { return cut_short_; }

 private:
  void call() {
    if (progress_(done_, total_) == Demand::kEnd) ending_ = true;
  }

  Progress progress_;
  std::mutex mutex_;
  std::atomic<std::int64_t> due_ns_ = 0;
  int done_ = 0, total_ = 0;
  std::atomic<bool> ending_ = false, cut_short_ = false;
};

SearchContext::SearchContext(int threads, Progress progress) : threads_(threads) {
  if (progress) shared_ = std::make_shared<SharedProgress>(std::move(progress));
}

SearchContext SearchContext::on_one_thread() const {
  SearchContext out = *this;
  out.threads_ = 1;
  return out;
}

SearchContext SearchContext::uncounted() const {
  SearchContext out = *this;
  out.counts_ = false;
  return out;
}

SearchContext SearchContext::for_layout() const {
  SearchContext out = *this;
  out.layout_only_ = true;
  return out;
}

SearchContext SearchContext::without_bound() const {
  SearchContext out = *this;
  out.bound_ = false;
  return out;
}

SearchContext SearchContext::without_sweep() const {
  SearchContext out = *this;
  out.sweep_ = false;
  return out;
}

SearchContext SearchContext::for_part(double from, double to) const {
  SearchContext out = *this;
  out.in_parts_ = true;
  out.from_ = from_ + (to_ - from_) * from;
  out.to_ = from_ + (to_ - from_) * to;
  return out;
}

void SearchContext::reach(double share) const {
  if (shared_ && counts_) shared_->reach(from_ + (to_ - from_) * std::clamp(share, 0.0, 1.0));
}

void SearchContext::count(int done, int total) const {
  if (!shared_ || !counts_) return;
  if (!in_parts_) return shared_->count(done, total);
  if (total > 0) reach(static_cast<double>(done) / total);
}

void SearchContext::report() const {
  if (shared_) shared_->report();
}

bool SearchContext::has_to_end() const { return shared_ && shared_->has_to_end(); }

bool SearchContext::cut_short() const { return shared_ && shared_->cut_short(); }

}  // namespace tramline
