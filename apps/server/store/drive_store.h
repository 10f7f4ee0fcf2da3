#pragma once
// The store of drives: their coverage, and the logs they were made from.

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "request/drive_request.h"
#include "server/store/store_folder.h"
#include "tramline/model/coverage.h"
#include "tramline/model/local_frame.h"

namespace tramline::server {

/// A log as received, with the options for reading it.
struct DriveSource {
  std::string log_name;   ///< as the user's file, or the feed, is called
  std::string extension;  ///< of the file that is kept: ".csv.gz"
  app::DriveOptions options;
};

struct KeptDrive {
  std::string id;
  std::string name;     ///< for people
  std::string field;    ///< id of the field it was driven on; that may be gone. Empty: none
  std::string plan;     ///< id of the plan it is compared with; that may be gone. Empty: none
  std::string created;  ///< "2026-03-14T08:15:00Z"
  DriveSource source;
  LocalFrame frame;
  nlohmann::ordered_json shown;  ///< what the API says of it
};

/// For each drive drives/ID.gpkg, a coverage file, drives/ID.csv or the like, its log, and drives/ID.json,
/// which is written last: without it there is no such drive. Safe for several threads.
class DriveStore {
 public:
  /// Files that cannot be read stay where they are and are listed in `warnings`; those of drives that were
  /// not finished when a server was killed go.
  DriveStore(const StoreFolder& folder, std::vector<std::string>& warnings);

  /// The latest first.
  std::vector<KeptDrive> list() const;
  bool has(const std::string& id) const;
  /// Throws HttpError(kNotFound).
  KeptDrive get(const std::string& id) const;
  /// Throws HttpError(kNotFound).
  KeptDrive rename(const std::string& id, const std::string& name);
  /// Throws HttpError(kNotFound).
  void remove(const std::string& id);

  std::filesystem::path coverage_file(const std::string& id) const;
  std::filesystem::path log_file(const std::string& id, const DriveSource& source) const;
  /// A copy of a log for a drive to be; throws failure where the disk is full. When the last copy of what
  /// comes back goes and there is no such drive by then, the log goes too.
  std::shared_ptr<void> take_log(const std::string& id, const DriveSource& source,
                                 const std::filesystem::path& from);
  /// Writes the coverage and all else. Precondition: the log is there.
  void add(const KeptDrive& drive, const Coverage& coverage);
  /// The same for one that is there. Throws HttpError(kNotFound) where it has been deleted: it stays so.
  void replace(const KeptDrive& drive, const Coverage& coverage);
  /// Those that a server was just replacing when it was killed: their files may not go together.
  std::vector<std::string> half_replaced() const;

 private:
  void put(const KeptDrive& drive, const std::filesystem::path& worked);
  void remove_files(const std::string& id) const;

  const StoreFolder& folder_;
  mutable std::mutex mutex_;
  std::map<std::string, KeptDrive> drives_;
};

/// The extension, of those that readers of logs know, that a name ends with; ".log" where it has none of
/// them.
std::string log_extension(const std::string& name);

}  // namespace tramline::server
