#pragma once
// Files to be kept by whoever asked for them.

#include <httplib.h>

#include <filesystem>
#include <string>

namespace tramline::server {

/// A folder for files that are made only to be sent; gone with it.
class PassingFolder {
 public:
  /// Throws failure.
  PassingFolder();
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;
  ~PassingFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The bytes of a file under a name for people, which may be anything. Throws failure where it cannot be
/// read.
void file_answer(httplib::Response& response, const std::filesystem::path& file, const std::string& name,
                 const char* type);

}  // namespace tramline::server
