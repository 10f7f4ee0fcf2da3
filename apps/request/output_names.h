#pragma once
// File names when one run plans several fields, or draws several obstacles.

#include <filesystem>
#include <set>
#include <string>

namespace tramline::app {

/// The id with everything but letters of ASCII, digits, '.', '_' and '-' replaced by '-', without '.' and
/// '-' at either end, cut at 80 bytes; "field" where nothing remains.
std::string as_file_name(const std::string& id);

/// Returns each name once: "-2", "-3" … is appended to a name that is in use.
class UniqueNames {
 public:
  std::string next(const std::string& wanted);

 private:
  std::set<std::string> taken_;
};

/// The use of a file name given for a run.
enum class Naming {
  kAsGiven,  ///< for the one file there is
  kWithId,   ///< "plan.gpkg" becomes "plan-<field id>.gpkg", the id as a file name, each name once
};

class OutputNames {
 public:
  OutputNames(std::filesystem::path given, Naming naming) : given_(std::move(given)), naming_(naming) {}
  std::filesystem::path next(const std::string& field_id);

 private:
  std::filesystem::path given_;
  Naming naming_;
  UniqueNames names_;
};

}  // namespace tramline::app
