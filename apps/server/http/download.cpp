#include "server/http/download.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <memory>

#include "request/output_names.h"
#include "server/store/scratch_folder.h"
#include "tramline/geometry/error.h"
#include "tramline/io/feed/descriptor.h"

namespace tramline::server {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPiece = std::size_t{1} << 16;

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
  const auto opened = std::make_shared<const io::Descriptor>(open(file.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (!opened->open() || fstat(opened->number(), &status) != 0 || status.st_size == 0)
    throw failure("the file cannot be read any more; is it still there?");
  response.set_header("Content-Disposition",
                      fmt::format("attachment; filename=\"{}{}\"; filename*=UTF-8''{}{}",
                                  app::as_file_name(name), extension, percent_coded(name), extension));
  // Piece by piece as the client takes it. What is open stays whole, whatever becomes of its name.
  response.set_content_provider(static_cast<std::size_t>(status.st_size), type,
                                [opened](std::size_t from, std::size_t size, httplib::DataSink& sink) {
                                  std::array<char, kPiece> piece;
                                  const ssize_t got =
                                      pread(opened->number(), piece.data(), std::min(size, piece.size()),
                                            static_cast<off_t>(from));
                                  return got > 0 && sink.write(piece.data(), static_cast<std::size_t>(got));
                                });
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
