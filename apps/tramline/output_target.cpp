#include "output_target.h"

#include <fmt/format.h>
#include <unistd.h>

#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

namespace fs = std::filesystem;

void require_extension(const std::string& name, const char* option,
                       std::initializer_list<const char*> extensions) {
  const std::string extension = fs::path(name).extension().string();
  std::string list;
  for (const char* one : extensions) {
    if (extension == one) return;
    list += (list.empty() ? "" : ", ") + std::string(one);
  }
  throw bad_input(fmt::format("{} '{}' must end in {}", option, name, list));
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
  const fs::path folder = fs::path(name).has_parent_path() ? fs::path(name).parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored))
    throw failure(
        fmt::format("{} '{}' cannot be written: there is no folder '{}'", option, name, folder.string()));
  if (access(folder.c_str(), W_OK) != 0)
    throw failure(fmt::format("{} '{}' cannot be written: no permission in folder '{}'", option, name,
                              folder.string()));
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
  if (access(above.c_str(), W_OK | X_OK) != 0)
    throw bad_input(
        fmt::format("{} '{}' cannot be written: no permission in folder '{}'", option, name, above.string()));
}

}  // namespace tramline::app
