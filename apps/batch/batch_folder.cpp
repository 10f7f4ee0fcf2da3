#include "batch/batch_folder.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <span>
#include <system_error>
#include <vector>

#include "report/report_parts.h"
#include "tramline/geometry/error.h"
#include "tramline/io/geopackage/whole_file.h"

namespace tramline::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* kBatchFile = "batch.json";

void write(const fs::path& file, const std::string& text) {
  io::write_whole(file, std::as_bytes(std::span(text)));
}

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The first key in which the two differ.
std::string difference(const ordered_json& ours, const ordered_json& theirs) {
  for (const auto& item : ours.items())
    if (!theirs.contains(item.key()) || theirs[item.key()] != item.value()) return item.key();
  return "format";
}

}  // namespace

void BatchFolder::begin(const ordered_json& batch, Start start) const {
  const fs::path file = folder_ / kBatchFile;
  std::error_code error;
  if (fs::exists(file, error)) {
    const auto former = ordered_json::parse(contents(file), nullptr, false);
    if (start == Start::kAnew)
      throw bad_input(fmt::format("'{}' holds a batch already: go on with --resume, or name another folder",
                                  folder_.string()));
    if (former != batch)
      throw bad_input(fmt::format(
          "'{}' holds another batch, with another '{}': give the parcels and options of that one, or "
          "another folder",
          folder_.string(), former.is_object() ? difference(batch, former) : "format"));
    return;
  }
  fs::create_directories(folder_ / "chunks", error);
  if (error)
    throw failure(fmt::format("folder '{}' could not be made: {}", folder_.string(), error.message()));
  write(file, json_text(batch, 2) + '\n');
}

fs::path BatchFolder::plans_of(long long chunk, std::size_t part) const {
  const std::string more = part == 0 ? "" : fmt::format("-{}", part + 1);
  return folder_ / "chunks" / fmt::format("{:06}{}.gpkg", chunk + 1, more);
}

fs::path BatchFolder::lines_of(long long chunk) const {
  return folder_ / "chunks" / fmt::format("{:06}.jsonl", chunk + 1);
}

bool BatchFolder::is_finished(long long chunk) const {
  std::error_code error;
  return fs::exists(lines_of(chunk), error);
}

void BatchFolder::tidy() const {
  std::error_code ignored;
  std::vector<fs::path> left;
  for (const char* folder : {".", "chunks"})
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / folder, ignored))
      if (entry.path().filename().string().starts_with('.') &&
          (entry.path().extension() == ".part" || entry.path().extension() == ".partial"))
        left.push_back(entry.path());
  for (const fs::path& file : left) fs::remove(file, ignored);
}

void BatchFolder::finish(long long chunk, const std::string& lines) const { write(lines_of(chunk), lines); }

}  // namespace tramline::app
