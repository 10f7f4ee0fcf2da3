#pragma once
// The store of machines.

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "server/store/store_folder.h"
#include "tramline/io/machine/machine_table.h"

namespace tramline::server {

/// All in one file, machines.gpkg. Safe for several threads.
class MachineStore {
 public:
  MachineStore(const StoreFolder& folder, std::vector<std::string>& warnings);

  /// In the order they were added.
  std::vector<io::ListedMachine> list() const;
  io::ListedMachine add(const Machine& machine);
  /// These throw HttpError(kNotFound).
  io::ListedMachine replace(const std::string& id, const Machine& machine);
  void remove(const std::string& id);

 private:
  void write(std::vector<io::ListedMachine> changed);
  std::vector<io::ListedMachine>::iterator find(std::vector<io::ListedMachine>& machines,
                                                const std::string& id) const;

  std::filesystem::path path_;
  mutable std::mutex mutex_;
  std::vector<io::ListedMachine> machines_;
};

}  // namespace tramline::server
