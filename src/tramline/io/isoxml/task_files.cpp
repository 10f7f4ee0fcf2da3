#include "tramline/io/isoxml/task_files.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <set>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/vector/gdal_messages.h"

namespace tramline::io {
namespace {

constexpr std::string_view kTaskData = "TASKDATA.XML";

std::string capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string file_part(const std::string& path) { return path.substr(path.find_last_of("/\\") + 1); }

std::string folder_part(const std::string& path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

/// "TLG00001" for "x/tlg00001.bin"; empty for other names.
std::string log_name(const std::string& path) {
  const std::string name = capitals(file_part(path));
  if (!name.starts_with("TLG") || !(name.ends_with(".XML") || name.ends_with(".BIN"))) return {};
  return name.substr(0, name.size() - 4);
}

bool is_zip(const std::string& path) { return capitals(path).ends_with(".ZIP"); }

std::vector<std::string> listed(char** list) {
  std::vector<std::string> out;
  for (int i = 0; list != nullptr && list[i] != nullptr; ++i) out.emplace_back(list[i]);
  CSLDestroy(list);
  std::sort(out.begin(), out.end());
  return out;
}

/// Folders below `root` with a TASKDATA.XML, or failing that with time logs; "" is the root.
std::set<std::string> task_folders(const std::vector<std::string>& names) {
  std::set<std::string> with_tasks, with_logs;
  for (const std::string& name : names) {
    // macOS adds a shadow of every file.
    if (name.starts_with("__MACOSX")) continue;
    if (capitals(file_part(name)) == kTaskData) with_tasks.insert(folder_part(name));
    if (!log_name(name).empty()) with_logs.insert(folder_part(name));
  }
  return with_tasks.empty() ? with_logs : with_tasks;
}

std::string joined(const std::string& folder, const std::string& name) {
  return folder.empty() ? name : name.empty() ? folder : folder + "/" + name;
}

/// Where a path leads: its root for GDAL and the folders there that hold task sets.
struct TaskSets {
  std::string root;
  std::set<std::string> folders;
  bool readable = true;
};

TaskSets find(const std::string& path) {
  std::error_code error;
  if (is_zip(path)) {
    TaskSets out{"/vsizip/{" + path + "}", {}, true};
    const std::vector<std::string> names = listed(VSIReadDirRecursive(out.root.c_str()));
    out.readable = !names.empty();
    out.folders = task_folders(names);
    return out;
  }
  if (std::filesystem::is_directory(path, error)) {
    TaskSets out{path, {}, true};
    std::vector<std::string> names = listed(VSIReadDir(path.c_str()));
    // The folder itself, or the one that holds the folder TASKDATA.
    const std::vector<std::string> top = names;
    for (const std::string& name : top)
      if (capitals(name) == "TASKDATA")
        for (const std::string& inner : listed(VSIReadDir(joined(path, name).c_str())))
          names.push_back(joined(name, inner));
    out.folders = task_folders(names);
    return out;
  }
  if (std::filesystem::exists(path, error) && (capitals(path).ends_with(".XML") || !log_name(path).empty()))
    return {folder_part(path).empty() ? "." : folder_part(path), {""}, true};
  return {};
}

}  // namespace

bool TaskFiles::looks_like_one(const std::string& path) {
  const GdalMessages silence;
  return !find(path).folders.empty();
}

TaskFiles TaskFiles::open(const std::string& path) {
  const GdalMessages silence;
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw bad_input(fmt::format("there is no file '{}'; check the path", path));
  const TaskSets found = find(path);
  if (!found.readable)
    throw bad_input(fmt::format(
        "'{}' cannot be read as a zip file; it is empty or was cut off, so fetch it again", path));
  if (found.folders.empty())
    throw bad_input(fmt::format("'{}' holds no TASKDATA.XML and no time log (TLG*.xml with .bin)", path));
  if (found.folders.size() > 1)
    throw bad_input(fmt::format("'{}' holds several task sets; unpack it and name one: {}", path,
                                fmt::join(found.folders, ", ")));
  TaskFiles out;
  out.path_ = path;
  out.only_log_ = log_name(path);
  out.folder_ = joined(found.root, *found.folders.begin());
  for (const std::string& name : listed(VSIReadDir(out.folder_.c_str())))
    out.names_.emplace(capitals(name), name);
  // A file that was named is the one to read, whatever it is called.
  if (!is_zip(path) && !std::filesystem::is_directory(path, error) && out.only_log_.empty())
    out.names_[std::string(kTaskData)] = file_part(path);
  return out;
}

std::optional<std::string> TaskFiles::read(const std::string& name) const {
  const auto at = names_.find(capitals(name));
  if (at == names_.end()) return std::nullopt;
  const GdalMessages silence;
  const std::string full = joined(folder_, at->second);
  const std::unique_ptr<VSILFILE, int (*)(VSILFILE*)> file(VSIFOpenL(full.c_str(), "rb"), VSIFCloseL);
  if (!file) throw bad_input(fmt::format("'{}': {} cannot be opened", path_, at->second));
  std::string out;
  std::vector<char> buffer(std::size_t{1} << 16);
  for (std::size_t got = 0; (got = VSIFReadL(buffer.data(), 1, buffer.size(), file.get())) > 0;) {
    out.append(buffer.data(), got);
    if (out.size() > kLargestTaskFile)
      throw bad_input(
          fmt::format("'{}': {} holds more than {} MiB when it is expanded, more than any task set", path_,
                      at->second, kLargestTaskFile >> 20));
  }
  return out;
}

}  // namespace tramline::io
