#pragma once
// --seconds: how long a search may take.

#include <chrono>
#include <optional>

#include "options/command_options.h"

namespace tramline::app {

void add_seconds_option(CommandOptions& command, std::optional<double>& seconds);

/// The time that one search has. It counts from the construction of the object.
class SearchTime {
 public:
  /// std::nullopt: as much as it needs.
  explicit SearchTime(std::optional<double> seconds) : seconds_(seconds) {}
  bool is_over() const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    return seconds_ && passed.count() >= *seconds_;
  }

 private:
  std::optional<double> seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace tramline::app
