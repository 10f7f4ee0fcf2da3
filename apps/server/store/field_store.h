#pragma once
// The store of fields.

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "server/store/store_folder.h"
#include "tramline/model/field.h"

namespace tramline::server {

struct KeptField {
  std::string id;
  std::string name;     ///< for people
  std::string created;  ///< "2026-03-14T08:15:00Z"
  Field field;          ///< its id is the name: what the program says of it, and its plans, call it so
  std::vector<Skipped> skipped;  ///< of its file
  std::string crop{};
  std::vector<std::string> tags{};  ///< words of the user's own, to find fields by
  std::string reshaped{};           ///< when its boundary or an obstacle was changed last; empty: never
};
using KeptFieldPtr = std::shared_ptr<const KeptField>;

/// A file for each, fields/ID.gpkg. Safe for several threads.
class FieldStore {
 public:
  /// Files that cannot be read stay where they are and are listed in `warnings`.
  FieldStore(const StoreFolder& folder, std::vector<std::string>& warnings);

  /// The latest first.
  std::vector<KeptFieldPtr> list() const;
  /// Throws HttpError(kNotFound).
  KeptFieldPtr get(const std::string& id) const;
  /// Null where there is none.
  KeptFieldPtr find(const std::string& id) const;
  /// What comes back is what the file holds.
  KeptFieldPtr add(const Field& field, const std::string& name, const std::vector<Skipped>& skipped,
                   const std::string& crop = "");
  /// Lets `how` change it; one change at a time, so that none undoes another, and none brings back what is
  /// deleted. Throws HttpError(kNotFound), and what `how` throws: then nothing is changed.
  KeptFieldPtr change(const std::string& id, const std::function<void(KeptField&)>& how);
  /// Throws HttpError(kNotFound).
  void remove(const std::string& id);

 private:
  KeptFieldPtr write(KeptField kept);
  KeptFieldPtr read(const std::string& id) const;

  const StoreFolder& folder_;
  std::mutex changing_;  ///< taken before mutex_
  mutable std::mutex mutex_;
  std::map<std::string, KeptFieldPtr> fields_;
};

}  // namespace tramline::server
