#include "server/store/store_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include "server/store/new_id.h"
#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

namespace fs = std::filesystem;

const char* variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : nullptr;
}

void make(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder, error))
    throw bad_input(fmt::format("'{}' cannot be made a folder ({}); choose another one", folder.string(),
                                error ? error.message() : "something else has that name"));
}

/// What a server that was killed was just writing.
void clear_left_overs(const fs::path& folder) {
  std::error_code ignored;
  fs::remove_all(folder / ".scratch", ignored);
  std::vector<fs::path> parts;
  for (fs::recursive_directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with('.') && name.ends_with(".part")) parts.push_back(entry->path());
  }
  for (const fs::path& part : parts) fs::remove(part, ignored);
}

}  // namespace

fs::path default_folder() {
  // The standard says that a path there that is not absolute is to be passed over.
  const char* data = variable("XDG_DATA_HOME");
  if (data != nullptr && fs::path(data).is_absolute()) return fs::path(data) / "tramline";
  if (const char* home = variable("HOME")) return fs::path(home) / ".local/share/tramline";
  throw bad_input("there is no home folder to keep fields and plans in; name a folder after 'serve'");
}

StoreFolder::StoreFolder(fs::path path) : path_(std::move(path)) {
  make(path_);
  const fs::path name = path_ / ".lock";
  lock_ = open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (lock_ < 0)
    throw bad_input(fmt::format("nothing can be written into '{}' ({}); choose another folder",
                                path_.string(), std::generic_category().message(errno)));
  if (flock(lock_, LOCK_EX | LOCK_NB) == 0) {
    clear_left_overs(path_);
    return;
  }
  close(lock_);
  throw bad_input(
      fmt::format("another tramline server keeps its things in '{}'; use that one, end it first, or "
                  "name another folder after 'serve'",
                  path_.string()));
}

StoreFolder::~StoreFolder() { close(lock_); }

fs::path StoreFolder::part(const char* name) const {
  fs::path out = path_ / name;
  std::error_code error;
  if (!fs::is_directory(path_, error))
    throw failure(fmt::format(
        "the folder '{}' that everything is kept in is gone; put it back, or start the server again",
        path_.string()));
  fs::create_directory(out, error);
  if (error || !fs::is_directory(out, error))
    throw failure(fmt::format("'{}' cannot be made ({}); is the disk full, or may nothing be written there?",
                              out.string(), error ? error.message() : "something else has that name"));
  return out;
}

fs::path StoreFolder::file(const char* kind, const std::string& id, const char* extension) const {
  if (!is_id(id)) throw std::logic_error("no id: " + id);
  return part(kind) / (id + extension);
}

std::vector<std::string> StoreFolder::ids(const char* kind, const char* extension) const {
  std::vector<std::string> out;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(path_ / kind, error)) {
    const std::string id = entry.path().stem().string();
    if (entry.path().extension() == extension && is_id(id)) out.push_back(id);
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace tramline::server
