#include "architecture/source_tree.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

namespace tramline::architecture {
namespace {

std::vector<std::string> files_known_to_git() {
  const std::string command =
      "git -C '" + source_root().string() + "' ls-files -z --cached --others --exclude-standard 2>/dev/null";
  std::vector<std::string> out;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return out;
  std::string name;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
    if (c != '\0') {
      name += static_cast<char>(c);
      continue;
    }
    out.push_back(name);
    name.clear();
  }
  if (pclose(pipe) != 0) out.clear();
  return out;
}

std::vector<std::string> files_on_disk() {
  static const std::set<std::string> kResults = {".git", ".cache", "build", "out"};
  std::vector<std::string> out;
  const auto root = source_root();
  for (auto entry = std::filesystem::recursive_directory_iterator(root);
       entry != std::filesystem::recursive_directory_iterator(); ++entry) {
    if (entry.depth() == 0 && kResults.contains(entry->path().filename().string()))
      entry.disable_recursion_pending();
    else if (entry->is_regular_file())
      out.push_back(std::filesystem::relative(entry->path(), root).string());
  }
  return out;
}

}  // namespace

std::filesystem::path source_root() { return TRAMLINE_SOURCE_DIR; }

std::vector<std::string> repository_files() {
  std::vector<std::string> files = files_known_to_git();
  if (files.empty()) files = files_on_disk();
  // A file that is deleted but not yet committed is still in git's list.
  std::erase_if(files,
                [](const std::string& f) { return !std::filesystem::is_regular_file(source_root() / f); });
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

bool is_product_source(const std::string& path) {
  const bool ours = path.starts_with("src/") || path.starts_with("include/") || path.starts_with("apps/") ||
                    path.starts_with("python/src/");
  return ours && (path.ends_with(".cpp") || path.ends_with(".h"));
}

bool is_in_room(const std::string& path, const std::string& room) {
  return path.starts_with("src/tramline/" + room + "/") || path.starts_with("include/tramline/" + room + "/");
}

std::string read(const std::string& path) {
  std::ifstream in(source_root() / path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace tramline::architecture
