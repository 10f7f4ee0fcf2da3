#include "server/store/field_store.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "server/http/http_error.h"
#include "server/store/new_id.h"
#include "server/store/remark_values.h"
#include "tramline/geometry/error.h"
#include "tramline/io/field/read_field.h"
#include "tramline/io/field/write_field.h"

namespace tramline::server {
namespace {

constexpr const char* kFields = "fields";

}  // namespace

FieldStore::FieldStore(const StoreFolder& folder, std::vector<std::string>& warnings) : folder_(folder) {
  for (const std::string& id : folder.ids(kFields)) {
    try {
      fields_[id] = read(id);
    } catch (const Error& error) {
      warnings.emplace_back(error.what());
    }
  }
}

KeptFieldPtr FieldStore::read(const std::string& id) const {
  io::StoredField stored = io::read_field(folder_.file(kFields, id));
  KeptField out{id,
                remark(stored.remarks, "name"),
                remark(stored.remarks, "created"),
                std::move(stored.field),
                skipped_in(remark(stored.remarks, "skipped")),
                remark(stored.remarks, "crop"),
                words_in(remark(stored.remarks, "tags")),
                remark(stored.remarks, "reshaped")};
  if (out.name.empty()) out.name = out.field.id;
  out.field.id = out.name;
  return std::make_shared<const KeptField>(std::move(out));
}

KeptFieldPtr FieldStore::write(KeptField kept) {
  kept.field.id = kept.name;
  io::write_field(kept.field, folder_.file(kFields, kept.id),
                  {{"name", kept.name},
                   {"created", kept.created},
                   {"skipped", skipped_text(kept.skipped)},
                   {"reshaped", kept.reshaped},
                   {"crop", kept.crop},
                   {"tags", words_text(kept.tags)}});
  KeptFieldPtr out = read(kept.id);
  const std::lock_guard lock(mutex_);
  fields_[kept.id] = out;
  return out;
}

std::vector<KeptFieldPtr> FieldStore::list() const {
  const std::lock_guard lock(mutex_);
  std::vector<KeptFieldPtr> out;
  for (auto entry = fields_.rbegin(); entry != fields_.rend(); ++entry) out.push_back(entry->second);
  return out;
}

KeptFieldPtr FieldStore::find(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto found = fields_.find(id);
  return found == fields_.end() ? nullptr : found->second;
}

KeptFieldPtr FieldStore::get(const std::string& id) const {
  if (KeptFieldPtr found = find(id)) return found;
  throw not_found("field", id);
}

KeptFieldPtr FieldStore::add(const Field& field, const std::string& name, const std::vector<Skipped>& skipped,
                             const std::string& crop) {
  return write({new_id(), name.empty() ? field.id : name, time_now(), field, skipped, crop});
}

KeptFieldPtr FieldStore::change(const std::string& id, const std::function<void(KeptField&)>& how) {
  const std::lock_guard one_at_a_time(changing_);
  KeptField changed = *get(id);
  how(changed);
  return write(std::move(changed));
}

void FieldStore::remove(const std::string& id) {
  const std::lock_guard one_at_a_time(changing_);
  const std::lock_guard lock(mutex_);
  if (fields_.erase(id) == 0) throw not_found("field", id);
  std::error_code ignored;
  std::filesystem::remove(folder_.file(kFields, id), ignored);
}

}  // namespace tramline::server
