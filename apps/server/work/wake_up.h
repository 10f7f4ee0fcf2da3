#pragma once
// Wakes a poll() from another thread.

namespace tramline::server {

class WakeUp {
 public:
  /// Throws failure where the system has no more descriptors.
  WakeUp();
  WakeUp(const WakeUp&) = delete;
  WakeUp& operator=(const WakeUp&) = delete;
  ~WakeUp();
  /// To be waited on for reading.
  int descriptor() const { return descriptor_; }
  /// From now on descriptor() is ready.
  void ring();

 private:
  int descriptor_ = -1;
};

}  // namespace tramline::server
