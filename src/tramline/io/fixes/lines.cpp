#include "tramline/io/fixes/lines.h"

#include <fmt/format.h>
#include <zlib.h>

#include <filesystem>
#include <vector>

#include "tramline/geometry/error.h"

namespace tramline::io {
namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 16;

Error too_large(const std::string& path, std::size_t most) {
  return bad_input(
      fmt::format("'{}' holds more than {} MiB when it is expanded; split it, or check that it is a log",
                  path, most >> 20));
}

}  // namespace

bool TextLines::next(std::string& line) {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find('\n');
  line = rest_.substr(0, end);
  rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
  return true;
}

struct FileLines::File {
  std::string path;
  gzFile handle = nullptr;
  std::vector<char> buffer = std::vector<char>(kBuffer);
  std::size_t at = 0, filled = 0, total = 0, most = kMostExpanded, lines = 0;
  bool ended = false;
  std::string cut_off;

  void fill() {
    const int got = gzread(handle, buffer.data(), static_cast<unsigned>(buffer.size()));
    at = 0;
    filled = got > 0 ? static_cast<std::size_t>(got) : 0;
    total += filled;
    int error = Z_OK;
    const char* const reason = gzerror(handle, &error);
    // A file cut off within its last block gives its bytes first and the error with them.
    if (got < 0 || error == Z_BUF_ERROR)
      cut_off = error == Z_BUF_ERROR ? "the compressed file is cut off" : std::string(reason);
    if (got <= 0 || error == Z_BUF_ERROR) ended = true;
    if (gzdirect(handle) == 0 && total > most) throw too_large(path, most);
  }
};

FileLines::FileLines(const std::string& path, std::size_t most_expanded) : file_(std::make_unique<File>()) {
  file_->path = path;
  file_->most = most_expanded;
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw bad_input(fmt::format("there is no file '{}'; check the path", path));
  if (std::filesystem::is_directory(path, error))
    throw bad_input(fmt::format("'{}' is a folder; name a file in it", path));
  file_->handle = gzopen(path.c_str(), "rb");
  if (file_->handle == nullptr)
    throw bad_input(fmt::format("'{}' cannot be opened; check that you may read it", path));
}

FileLines::~FileLines() {
  if (file_->handle != nullptr) gzclose(file_->handle);
}

bool FileLines::next(std::string& line) {
  File& file = *file_;
  line.clear();
  if (++file.lines > kMostLines)
    throw bad_input(fmt::format("'{}' has more than {} lines; split it, or check that it is a log", file.path,
                                kMostLines));
  bool any = false;
  while (true) {
    if (file.at == file.filled) {
      if (file.ended) return any;
      file.fill();
      if (file.filled == 0) return any;
    }
    any = true;
    const std::string_view rest(file.buffer.data() + file.at, file.filled - file.at);
    const std::size_t end = rest.find('\n');
    line.append(rest.substr(0, end));
    if (line.size() > kLongestLine)
      throw bad_input(
          fmt::format("'{}' has a line longer than {} bytes; it is not a text log", file.path, kLongestLine));
    file.at += end == std::string_view::npos ? rest.size() : end + 1;
    if (end != std::string_view::npos) return true;
  }
}

std::string FileLines::cut_off() const { return file_->cut_off; }

std::string first_bytes(const std::string& path, std::size_t most) {
  const gzFile handle = gzopen(path.c_str(), "rb");
  if (handle == nullptr)
    throw bad_input(fmt::format("'{}' cannot be opened; check that you may read it", path));
  std::string out(most, '\0');
  const int got = gzread(handle, out.data(), static_cast<unsigned>(most));
  gzclose(handle);
  out.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return out;
}

std::string whole_text(const std::string& path) {
  const gzFile handle = gzopen(path.c_str(), "rb");
  if (handle == nullptr)
    throw bad_input(fmt::format("'{}' cannot be opened; check that you may read it", path));
  std::string out;
  std::vector<char> buffer(kBuffer);
  int got = 0;
  while ((got = gzread(handle, buffer.data(), static_cast<unsigned>(buffer.size()))) > 0) {
    out.append(buffer.data(), static_cast<std::size_t>(got));
    if (out.size() > kMostWholeText) break;
  }
  gzclose(handle);
  if (out.size() > kMostWholeText) throw too_large(path, kMostWholeText);
  return out;
}

}  // namespace tramline::io
