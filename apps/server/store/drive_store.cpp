#include "server/store/drive_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include "report/report_parts.h"
#include "server/http/http_error.h"
#include "server/input/drive_input.h"
#include "server/store/new_id.h"
#include "server/store/scratch_folder.h"
#include "server/store/whole_text.h"
#include "tramline/geometry/error.h"
#include "tramline/io/coverage/write_coverage.h"

namespace tramline::server {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* kKind = "drives";
/// Lies beside a drive while its files are replaced, one after another.
constexpr const char* kMark = ".replacing";

/// Longer ones first.
constexpr std::array<std::string_view, 16> kExtensions = {
    ".csv.gz", ".txt.gz", ".log.gz", ".nmea.gz", ".geojson", ".gpkg", ".json", ".nmea",
    ".shp",    ".zip",    ".gpx",    ".csv",     ".txt",     ".log",  ".xml",  ".bin"};

ordered_json frame_json(const LocalFrame& frame) {
  return {{"geodetic", frame.geodetic},
          {"origin_lon_deg", frame.origin_lon_deg},
          {"origin_lat_deg", frame.origin_lat_deg},
          {"origin_x_m", frame.origin_x_m},
          {"origin_y_m", frame.origin_y_m}};
}

LocalFrame frame_in(const ordered_json& json) {
  return {json.at("geodetic"), json.at("origin_lon_deg"), json.at("origin_lat_deg"), json.at("origin_x_m"),
          json.at("origin_y_m")};
}

ordered_json kept_json(const KeptDrive& drive) {
  const DriveSource& source = drive.source;
  return {{"name", drive.name},
          {"field", drive.field},
          {"plan", drive.plan},
          {"created", drive.created},
          {"log",
           {{"name", source.log_name},
            {"extension", source.extension},
            {"entry", source.options.log.log},
            {"width_m", app::number_json(source.options.drive.width_m)},
            {"options", drive_options_json(source.options)}}},
          {"frame", frame_json(drive.frame)},
          {"shown", drive.shown}};
}

KeptDrive drive_in(const std::string& id, const ordered_json& json) {
  KeptDrive out;
  out.id = id;
  out.name = json.at("name");
  out.field = json.at("field");
  out.plan = json.at("plan");
  out.created = json.at("created");
  const ordered_json& log = json.at("log");
  const ordered_json& width = log.at("width_m");
  out.source.log_name = log.at("name");
  out.source.extension = log_extension(log.at("extension"));
  out.source.options = drive_options_in(
      log.at("options"), width.is_null() ? std::nullopt : std::optional<double>(width.get<double>()));
  out.source.options.log.log = log.at("entry");
  out.frame = frame_in(json.at("frame"));
  out.shown = json.at("shown");
  return out;
}

/// Whether a name looks like one of new_id(): other files in the folder are none of ours.
bool made_here(const std::string& id) {
  constexpr std::size_t kDate = 8, kTime = 15;
  if (!is_id(id) || id.size() <= kTime || id[kDate] != '-' || id[kTime] != '-') return false;
  return std::all_of(id.begin(), id.begin() + kTime,
                     [](unsigned char c) { return std::isdigit(c) != 0 || c == '-'; });
}

KeptDrive read_drive(const fs::path& path, const std::string& id) {
  try {
    std::ifstream file(path, std::ios::binary);
    return drive_in(id, ordered_json::parse(file));
  } catch (const std::exception& error) {
    throw bad_input(fmt::format("{} cannot be read as a drive ({})", path.string(), error.what()));
  }
}

}  // namespace

std::string log_extension(const std::string& name) {
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const std::string_view extension : kExtensions)
    if (lower.ends_with(extension)) return std::string(extension);
  return ".log";
}

DriveStore::DriveStore(const StoreFolder& folder, std::vector<std::string>& warnings) : folder_(folder) {
  for (const std::string& id : folder.ids(kKind, ".json")) {
    try {
      drives_[id] = read_drive(folder.file(kKind, id, ".json"), id);
    } catch (const Error& error) {
      warnings.emplace_back(error.what());
    }
  }
  // What has no .json was being evaluated when a server was killed; the user still has the log.
  std::error_code ignored;
  std::vector<fs::path> unfinished;
  for (const auto& entry : fs::directory_iterator(folder.path() / kKind, ignored)) {
    const std::string file = entry.path().filename().string();
    const std::string id = file.substr(0, file.find('.'));
    if (made_here(id) && !fs::exists(folder.file(kKind, id, ".json"), ignored))
      unfinished.push_back(entry.path());
  }
  for (const fs::path& path : unfinished) fs::remove(path, ignored);
}

std::vector<KeptDrive> DriveStore::list() const {
  const std::lock_guard lock(mutex_);
  std::vector<KeptDrive> out;
  std::transform(drives_.rbegin(), drives_.rend(), std::back_inserter(out),
                 [](const auto& entry) { return entry.second; });
  return out;
}

bool DriveStore::has(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  return drives_.contains(id);
}

KeptDrive DriveStore::get(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto found = drives_.find(id);
  if (found == drives_.end()) throw not_found("drive", id);
  return found->second;
}

KeptDrive DriveStore::rename(const std::string& id, const std::string& name) {
  const std::lock_guard lock(mutex_);
  const auto found = drives_.find(id);
  if (found == drives_.end()) throw not_found("drive", id);
  KeptDrive out = found->second;
  out.name = name;
  out.shown["name"] = name;
  write_whole(folder_.file(kKind, id, ".json"), app::json_line(kept_json(out)) + '\n');
  found->second = out;
  return out;
}

void DriveStore::remove(const std::string& id) {
  const std::lock_guard lock(mutex_);
  if (drives_.erase(id) == 0) throw not_found("drive", id);
  remove_files(id);
}

fs::path DriveStore::coverage_file(const std::string& id) const { return folder_.file(kKind, id); }

fs::path DriveStore::log_file(const std::string& id, const DriveSource& source) const {
  return folder_.file(kKind, id,
                      source.extension == ".gpkg" || source.extension == ".json"
                          ? (".log" + source.extension).c_str()
                          : source.extension.c_str());
}

std::shared_ptr<void> DriveStore::take_log(const std::string& id, const DriveSource& source,
                                           const fs::path& from) {
  std::shared_ptr<void> out(this, [this, id](void*) {
    const std::lock_guard lock(mutex_);
    if (!drives_.contains(id)) remove_files(id);
  });
  std::error_code fault;
  const fs::path to = log_file(id, source);
  fs::create_hard_link(from, to, fault);
  if (fault && !fs::copy_file(from, to, fs::copy_options::overwrite_existing, fault))
    throw failure(fmt::format("the log could not be kept ({}); is the disk full?", fault.message()));
  return out;
}

/// To be called with the mutex held: nobody deletes it half-way.
void DriveStore::put(const KeptDrive& drive, const fs::path& worked) {
  fs::rename(worked, coverage_file(drive.id));
  write_whole(folder_.file(kKind, drive.id, ".json"), app::json_line(kept_json(drive)) + '\n');
  drives_[drive.id] = drive;
}

void DriveStore::add(const KeptDrive& drive, const Coverage& coverage) {
  const ScratchFolder scratch(folder_);
  io::write_coverage(coverage, scratch.path() / "worked.gpkg");
  const std::lock_guard lock(mutex_);
  put(drive, scratch.path() / "worked.gpkg");
}

void DriveStore::replace(const KeptDrive& drive, const Coverage& coverage) {
  const ScratchFolder scratch(folder_);
  io::write_coverage(coverage, scratch.path() / "worked.gpkg");
  const std::lock_guard lock(mutex_);
  if (!drives_.contains(drive.id)) throw not_found("drive", drive.id);
  const fs::path mark = folder_.file(kKind, drive.id, kMark);
  write_whole(mark, "");
  put(drive, scratch.path() / "worked.gpkg");
  fs::remove(mark);
}

std::vector<std::string> DriveStore::half_replaced() const {
  std::vector<std::string> out = folder_.ids(kKind, kMark);
  const std::lock_guard lock(mutex_);
  std::erase_if(out, [&](const std::string& id) { return !drives_.contains(id); });
  return out;
}

/// The .json first: what is left of a drive without it goes at the next start.
void DriveStore::remove_files(const std::string& id) const {
  std::error_code ignored;
  fs::remove(folder_.file(kKind, id, ".json"), ignored);
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder_.path() / kKind, ignored))
    if (entry.path().filename().string().starts_with(id + '.')) files.push_back(entry.path());
  for (const fs::path& file : files) fs::remove(file, ignored);
}

}  // namespace tramline::server
