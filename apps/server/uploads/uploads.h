#pragma once
// Uploaded files that have not been used yet.

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "server/store/store_folder.h"

namespace tramline::server {

enum class UploadKind { kFields, kLog, kPlan, kUnknown };
const char* name(UploadKind kind);  ///< fields, log, plan, unknown

struct Upload {
  std::string id;
  std::string name;            ///< as the user's file is called, for people only
  std::filesystem::path path;  ///< of the bytes; its name is made by the server but for a known extension
  std::size_t bytes = 0;
  UploadKind kind = UploadKind::kUnknown;

  /// A sentence of the library about the path, about the user's file; "ID:3" becomes "mill field, field 3",
  /// where the upload has an id.
  std::string in_its_name(std::string sentence) const;
};

/// Safe for several threads. Gone when the server ends, and at its next start at the latest.
class Uploads {
 public:
  explicit Uploads(const StoreFolder& folder);
  ~Uploads();

  /// A new one, without bytes and not to be found yet.
  Upload begin(const std::string& name) const;
  /// Of one that is not to be kept.
  void discard(const Upload& upload) const;
  /// From now on it can be found.
  void keep(const Upload& upload);
  /// These throw HttpError(kNotFound).
  Upload get(const std::string& id) const;
  void remove(const std::string& id);
  /// Those that are older than a day go.
  void forget_old();
  /// Held while a new upload is looked through.
  std::mutex& reading() { return reading_; }

 private:
  struct Entry {
    Upload upload;
    std::chrono::steady_clock::time_point since;
  };
  const StoreFolder& store_;
  const std::filesystem::path folder_;
  std::mutex reading_;
  mutable std::mutex mutex_;
  std::map<std::string, Entry> entries_;
};

/// The name of a user's file without folders and its extensions: "mill field" of "C:\\maps\\mill
/// field.geojson".
std::string stem_of(const std::string& name);

/// Readers name features without an id after their layer, and layers after the file: "ID:3" becomes
/// "mill field:3".
std::string id_in_its_name(const Upload& upload, const std::string& id);

}  // namespace tramline::server
