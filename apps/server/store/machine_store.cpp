#include "server/store/machine_store.h"

#include <algorithm>
#include <utility>

#include "server/http/http_error.h"
#include "server/store/new_id.h"
#include "tramline/geometry/error.h"

namespace tramline::server {

MachineStore::MachineStore(const StoreFolder& folder, std::vector<std::string>& warnings)
    : path_(folder.path() / "machines.gpkg") {
  std::error_code ignored;
  if (!std::filesystem::exists(path_, ignored)) return;
  try {
    machines_ = io::read_machines(path_);
  } catch (const Error& error) {
    // Out of the way, or the next machine would be written over it.
    std::filesystem::rename(path_, path_.string() + ".unreadable", ignored);
    warnings.emplace_back(error.what());
  }
}

std::vector<io::ListedMachine> MachineStore::list() const {
  const std::lock_guard lock(mutex_);
  return machines_;
}

/// What is on the disk and what is remembered never differ. To be called with the mutex held.
void MachineStore::write(std::vector<io::ListedMachine> changed) {
  io::write_machines(changed, path_);
  machines_ = std::move(changed);
}

std::vector<io::ListedMachine>::iterator MachineStore::find(std::vector<io::ListedMachine>& machines,
                                                            const std::string& id) const {
  const auto found =
      std::find_if(machines.begin(), machines.end(), [&](const auto& listed) { return listed.id == id; });
  if (found == machines.end()) throw not_found("machine", id);
  return found;
}

io::ListedMachine MachineStore::add(const Machine& machine) {
  const std::lock_guard lock(mutex_);
  std::vector<io::ListedMachine> changed = machines_;
  changed.push_back({new_id(), machine});
  write(std::move(changed));
  return machines_.back();
}

io::ListedMachine MachineStore::replace(const std::string& id, const Machine& machine) {
  const std::lock_guard lock(mutex_);
  std::vector<io::ListedMachine> changed = machines_;
  find(changed, id)->machine = machine;
  write(std::move(changed));
  return {id, machine};
}

void MachineStore::remove(const std::string& id) {
  const std::lock_guard lock(mutex_);
  std::vector<io::ListedMachine> changed = machines_;
  changed.erase(find(changed, id));
  write(std::move(changed));
}

}  // namespace tramline::server
