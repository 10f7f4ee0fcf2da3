#include "tramline/io/geopackage/memory_folder.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>

namespace tramline::io {

MemoryFolder::MemoryFolder() {
  static std::atomic<unsigned> count{0};
  path_ = fmt::format("/vsimem/tramline_{}_{}", getpid(), count++);
  VSIMkdir(path_.c_str(), 0700);
}

MemoryFolder::~MemoryFolder() { VSIRmdirRecursive(path_.c_str()); }

std::vector<std::string> MemoryFolder::files() const {
  const CPLStringList names(VSIReadDir(path_.c_str()));
  std::vector<std::string> out;
  for (int i = 0; i < names.size(); ++i) out.emplace_back(names[i]);
  std::sort(out.begin(), out.end());
  return out;
}

std::span<const std::byte> MemoryFolder::bytes(const std::string& name) const {
  vsi_l_offset size = 0;
  const GByte* data = VSIGetMemFileBuffer(file(name).c_str(), &size, FALSE);
  return data == nullptr ? std::span<const std::byte>()
                         : std::as_bytes(std::span(data, static_cast<std::size_t>(size)));
}

}  // namespace tramline::io
