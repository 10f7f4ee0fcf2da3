#pragma once
// The pictures of --zoom-obstacles.

#include <filesystem>
#include <string>

#include "request/output_names.h"
#include "tramline/model/plan.h"

namespace tramline::app {

/// Files "<field id>-obstacle-<n>.png" in one folder: a close-up of every obstacle that is not
/// passable, n its number as in the plan file, from 1. Two fields of one id get names of their own.
class CloseUps {
 public:
  /// An empty name: write() does nothing.
  explicit CloseUps(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Makes the folder if it is missing. Throws Error(kFailure) where it or a file cannot be written.
  void write(const Plan& plan);

 private:
  std::filesystem::path folder_;
  UniqueNames names_;
};

}  // namespace tramline::app
