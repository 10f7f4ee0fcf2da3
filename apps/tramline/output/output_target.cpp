#include "output/output_target.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

namespace fs = std::filesystem;

void require_extension(const std::string& name, const char* option,
                       std::initializer_list<const char*> extensions) {
  std::string extension = fs::path(name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  std::string list;
  for (const char* one : extensions) {
    if (extension == one) return;
    list += (list.empty() ? "" : ", ") + std::string(one);
  }
  throw bad_input(fmt::format("{} '{}' must end in {}", option, name, list));
}

/// A permission tells little of what a folder takes (root may write anywhere, and /proc takes nothing):
/// a file of this name is made in it and taken away again. The cause, or "" where that went well.
std::string cause_against_file(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600);
  if (descriptor < 0) return std::generic_category().message(errno);
  close(descriptor);
  unlink(file.c_str());
  return "";
}

/// As long as the longest name under which a result is written before it gets its own.
std::string name_of_trial(const std::string& name) { return fmt::format(".{}.{}.partial", name, getpid()); }

/// Folders made on trial; they are gone with the object.
class TrialFolders {
 public:
  TrialFolders() = default;
  TrialFolders(const TrialFolders&) = delete;
  TrialFolders& operator=(const TrialFolders&) = delete;
  ~TrialFolders() {
    std::error_code ignored;
    for (auto made = made_.rbegin(); made != made_.rend(); ++made) fs::remove(*made, ignored);
  }
  /// The cause, or "" where the folder is there now.
  std::string cause_against(const fs::path& folder) {
    std::error_code error;
    if (fs::create_directory(folder, error)) made_.push_back(folder);
    return error ? error.message() : "";
  }

 private:
  std::vector<fs::path> made_;
};

/// Why nothing can be written into the folder, which is made as far as it is missing; "" where it can.
std::string cause_against_folder(const fs::path& folder) {
  TrialFolders made;
  fs::path path;
  for (const fs::path& part : fs::absolute(folder)) {
    path /= part;
    std::error_code error;
    if (part.empty() || fs::is_directory(path, error)) continue;
    if (std::string cause = made.cause_against(path); !cause.empty()) return cause;
  }
  return cause_against_file(path / name_of_trial(""));
}

}  // namespace

void require_writable(const std::string& name, const char* option,
                      std::initializer_list<const char*> extensions, const std::vector<std::string>& inputs) {
  if (name.empty()) return;
  require_extension(name, option, extensions);
  std::error_code ignored;
  if (fs::is_directory(name, ignored))
    throw bad_input(fmt::format("{} '{}' is a folder; name a file in it", option, name));
  for (const std::string& input : inputs)
    if (!input.empty() && fs::equivalent(name, input, ignored))
      throw bad_input(
          fmt::format("{} '{}' would overwrite the input file; choose another name", option, name));
  const fs::path path(name);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored))
    throw bad_input(
        fmt::format("{} '{}' cannot be written: there is no folder '{}'", option, name, folder.string()));
  const std::string cause = cause_against_file(folder / name_of_trial(path.filename().string()));
  if (!cause.empty())
    throw bad_input(fmt::format("{} '{}' cannot be written: folder '{}' takes no file of that name ({})",
                                option, name, folder.string(), cause));
}

void require_folder(const std::string& name, const char* option) {
  if (name.empty()) return;
  // The nearest folder that is there: what is missing below it can be made in it, if anything can.
  fs::path above = fs::absolute(name);
  std::error_code error;
  fs::file_type type = fs::symlink_status(above, error).type();
  while (type == fs::file_type::not_found && above.has_relative_path()) {
    above = above.parent_path();
    type = fs::symlink_status(above, error).type();
  }
  if (type == fs::file_type::none)
    throw bad_input(fmt::format("{} '{}' cannot be a folder: {}", option, name, error.message()));
  std::error_code ignored;
  if (!fs::is_directory(above, ignored))
    throw bad_input(fmt::format("{} '{}' cannot be a folder: '{}' is a file", option, name, above.string()));
  if (const std::string cause = cause_against_folder(name); !cause.empty())
    throw bad_input(
        fmt::format("{} '{}' cannot be written into: the folder takes no files ({})", option, name, cause));
}

}  // namespace tramline::app
