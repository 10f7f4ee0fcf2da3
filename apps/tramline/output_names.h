#pragma once
// File names when one run plans several fields.

#include <filesystem>
#include <set>
#include <string>

namespace tramline::app {

/// One field: the name as given. Several: "plan.gpkg" becomes "plan-<field id>.gpkg", with everything
/// but letters, digits, '.', '_' and '-' of the id replaced by '-' and cut at 80 bytes, and "-2", "-3" …
/// added where two fields would share a name.
class OutputNames {
 public:
  OutputNames(std::filesystem::path given, bool several) : given_(std::move(given)), several_(several) {}
  std::filesystem::path next(const std::string& field_id);

 private:
  std::filesystem::path given_;
  bool several_;
  std::set<std::string> taken_;
};

}  // namespace tramline::app
