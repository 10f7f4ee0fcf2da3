#include "page/page_asset.h"

#include <algorithm>

namespace tramline::app {

std::optional<Asset> page_asset(std::string_view path) {
  const std::string_view wanted = path == "/" ? "/index.html" : path;
  const std::span<const Asset> all = page_assets();
  const auto found = std::ranges::lower_bound(all, wanted, {}, &Asset::path);
  if (found == all.end() || found->path != wanted) return std::nullopt;
  return *found;
}

}  // namespace tramline::app
