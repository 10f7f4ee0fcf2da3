#pragma once
// The pictures of --zoom-obstacles.

#include <filesystem>
#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline::app {

/// Files "<field>-obstacle-<n>.png" in one folder: a close-up of every obstacle that is not
/// passable, n its number as in the plan file, from 1.
class CloseUps {
 public:
  /// An empty name: write() does nothing.
  explicit CloseUps(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Makes the folder if it is missing, and gives the names of the files. `field` begins them. Throws
  /// Error(kFailure) where it or a file cannot be written.
  std::vector<std::string> write(const Plan& plan, const std::string& field) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace tramline::app
