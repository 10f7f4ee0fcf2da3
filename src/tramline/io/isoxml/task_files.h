#pragma once
// The files of an ISOXML task set, in a folder or a zip.

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace tramline::io {

/// The limit on the size of a file of a task set; larger ones are refused.
inline constexpr std::size_t kLargestTaskFile = std::size_t{128} << 20;

/// The folder with TASKDATA.XML, on disk or in a zip. Names are found in any case, as terminals write them.
class TaskFiles {
 public:
  /// `path`: a folder, a zip (the task set may lie in any folder of it), a TASKDATA.XML, or one time log
  /// (TLG00001.xml or .bin). Throws bad_input when there is nothing of the kind, and when a zip holds several
  /// task sets or cannot be read.
  static TaskFiles open(const std::string& path);
  /// Whether open() would find a task set or a time log.
  static bool looks_like_one(const std::string& path);

  /// The bytes of a file; nullopt when there is none of this name. Throws bad_input when it cannot be read
  /// and when it expands to more than kLargestTaskFile bytes.
  std::optional<std::string> read(const std::string& name) const;

  /// The path as the user gave it, for messages.
  const std::string& path() const { return path_; }
  /// "TLG00001" when one time log was named rather than the task set.
  const std::string& only_log() const { return only_log_; }

 private:
  std::string path_;
  std::string folder_;                        ///< as GDAL names it
  std::map<std::string, std::string> names_;  ///< names in capitals, with the actual names
  std::string only_log_;
};

}  // namespace tramline::io
