#include "server/http/download.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "request/output_names.h"
#include "server/store/scratch_folder.h"
#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

namespace fs = std::filesystem;

/// As RFC 5987 has names with letters beyond ASCII.
std::string percent_coded(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                       c == '-' || c == '_' || c == '.';
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

}  // namespace

void send_file(httplib::Response& response, const fs::path& file, const std::string& name,
               const std::string& extension, const char* type) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream || bytes.empty()) throw failure("the file cannot be read any more; is it still there?");
  response.set_header("Content-Disposition",
                      fmt::format("attachment; filename=\"{}{}\"; filename*=UTF-8''{}{}",
                                  app::as_file_name(name), extension, percent_coded(name), extension));
  response.set_content(bytes, type);
}

void send_written(httplib::Response& response, const StoreFolder& folder, const std::string& name,
                  const std::string& extension, const char* type,
                  const std::function<void(const fs::path&)>& write) {
  const ScratchFolder scratch(folder);
  const fs::path file = scratch.path() / ("file" + extension);
  write(file);
  send_file(response, file, name, extension, type);
}

}  // namespace tramline::server
