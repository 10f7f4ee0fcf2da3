#include "tramline/render/page/picture_file.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <ctime>
#include <fstream>

#include "tramline/geometry/error.h"

namespace tramline::render {

PictureFormat format_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".png") return PictureFormat::kPng;
  if (extension == ".svg") return PictureFormat::kSvg;
  if (extension == ".pdf") return PictureFormat::kPdf;
  throw bad_input(fmt::format("picture {}: a picture's name ends in .png, .svg or .pdf", path.string()));
}

void write_whole(const std::filesystem::path& path, const std::string& bytes) {
  namespace fs = std::filesystem;
  const fs::path beside =
      path.parent_path() / fmt::format(".{}.{}.partial", path.filename().string(), ::getpid());
  std::ofstream file(beside, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  std::error_code error;
  if (file) fs::rename(beside, path, error);
  if (file && !error) return;
  std::error_code ignored;
  fs::remove(beside, ignored);
  throw failure(fmt::format("picture {} could not be written: is its folder there, writable and not full?",
                            path.string()));
}

std::string picture_date() {
  std::time_t moment = 0;
  if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) {
    char* end = nullptr;
    const long long seconds = std::strtoll(epoch, &end, 10);
    // Up to the year 9999: beyond it the date has no four-digit year.
    if (end != epoch && *end == '\0' && seconds >= 0 && seconds < 253402300800LL) moment = seconds;
  }
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}Z", fmt::gmtime(moment));
}

}  // namespace tramline::render
