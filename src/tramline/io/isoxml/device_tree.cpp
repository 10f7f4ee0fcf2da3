#include "tramline/io/isoxml/device_tree.h"

#include <algorithm>
#include <map>
#include <utility>

namespace tramline::io {

bool is_small_part(const DeviceElement& element) {
  return element.type == element_kind::kSection || element.type == element_kind::kUnit;
}

DeviceTree::DeviceTree(std::vector<DeviceElement> elements)
    : elements_(std::move(elements)), parents_(elements_.size()), children_(elements_.size()) {
  std::map<std::pair<std::string, long long>, std::size_t> by_object;
  for (std::size_t i = 0; i < size(); ++i)
    by_object.emplace(std::pair{elements_[i].device, elements_[i].object}, i);
  for (std::size_t i = 0; i < size(); ++i)
    if (const auto at = by_object.find({elements_[i].device, elements_[i].parent});
        at != by_object.end() && at->second != i)
      parents_[i] = at->second;
  cut_circles();
  std::map<std::string, std::size_t> devices;
  for (std::size_t i = 0; i < size(); ++i) {
    if (parents_[i]) {
      children_[*parents_[i]].push_back(i);
      continue;
    }
    const auto [at, is_new] = devices.emplace(elements_[i].device, devices_.size());
    if (is_new) devices_.emplace_back();
    devices_[at->second].push_back(i);
  }
  for (auto* lists : {&children_, &devices_})
    for (std::vector<std::size_t>& places : *lists) sort_by_number(places);
}

void DeviceTree::cut_circles() {
  constexpr int kDeepest = 32, kBeingWalked = -1;
  std::vector<int> depths(size(), 0);  // 0: not known; a root has 1
  for (std::size_t i = 0; i < size(); ++i) {
    std::vector<std::size_t> walk;
    std::size_t at = i;
    while (depths[at] == 0) {
      depths[at] = kBeingWalked;
      walk.push_back(at);
      if (!parents_[at]) break;
      if (depths[*parents_[at]] == kBeingWalked) {
        parents_[at].reset();
        break;
      }
      at = *parents_[at];
    }
    for (; !walk.empty(); walk.pop_back()) {
      const std::size_t child = walk.back();
      if (parents_[child] && depths[*parents_[child]] >= kDeepest) parents_[child].reset();
      depths[child] = parents_[child] ? depths[*parents_[child]] + 1 : 1;
    }
  }
}

void DeviceTree::sort_by_number(std::vector<std::size_t>& places) const {
  std::stable_sort(places.begin(), places.end(),
                   [&](std::size_t a, std::size_t b) { return elements_[a].number < elements_[b].number; });
}

std::vector<std::size_t> DeviceTree::path_to_root(std::size_t i) const {
  std::vector<std::size_t> out{i};
  for (auto at = parents_[i]; at; at = parents_[*at]) out.push_back(*at);
  return out;
}

bool DeviceTree::is_within(std::size_t i, std::size_t ancestor) const {
  const std::vector<std::size_t> path = path_to_root(i);
  return std::find(path.begin(), path.end(), ancestor) != path.end();
}

}  // namespace tramline::io
