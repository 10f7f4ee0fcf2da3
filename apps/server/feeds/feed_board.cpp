#include "server/feeds/feed_board.h"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

#include "report/report_parts.h"
#include "server/drives/work_log_file.h"
#include "server/http/http_error.h"
#include "server/input/drive_input.h"
#include "server/store/whole_text.h"
#include "tramline/io/coverage/write_coverage.h"

namespace tramline::server {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* kKind = "feeds";

ordered_json note_json(const FeedNote& note) {
  const double width_m = note.log.options.drive.width_m;
  return {{"name", note.name},
          {"source", note.source},
          {"field", note.field},
          {"created", note.created},
          {"width_m", width_m > 0 ? ordered_json(width_m) : ordered_json()},
          {"options", drive_options_json(note.log.options)}};
}

FeedNote note_in(const std::string& id, const ordered_json& json) {
  FeedNote out;
  out.id = id;
  out.name = json.at("name");
  out.source = json.at("source");
  out.field = json.at("field");
  out.created = json.at("created");
  const ordered_json& width = json.at("width_m");
  out.log.options = drive_options_in(
      json.at("options"), width.is_null() ? std::nullopt : std::optional<double>(width.get<double>()));
  out.log.log_name = out.source;
  out.log.extension = ".log";
  return out;
}

}  // namespace

std::shared_ptr<void> FeedBoard::take_room() {
  if (open_.fetch_add(1) >= most_) {
    --open_;
    throw HttpError(
        Fault::kBusy,
        fmt::format("{} live feeds are open already, which is as many as there can be; end one of them",
                    most_));
  }
  return {this, [this](void*) { --open_; }};
}

OpenFeed FeedBoard::open(const FeedNote& note, std::unique_ptr<io::Feed> source,
                         const app::WorkGround& ground, std::shared_ptr<void> room) {
  write_whole(folder_.file(kKind, note.id, ".json"), app::json_line(note_json(note)) + '\n');
  FeedOrder order;
  order.source = std::move(source);
  order.ground = ground;
  order.settings = evaluate_settings(note.log.options);
  order.log = note.log.options.log;
  order.raw_log = raw_log(note.id);
  order.save = [raw = order.raw_log, log = note.log, ground, to = folder_.file(kKind, note.id)] {
    io::write_coverage(evaluated_log(read_work_log(raw, log), ground, evaluate_settings(log.options), {}),
                       to);
    // What it took is given back, and not kept for the next time: the feed goes on for hours.
    malloc_trim(0);
  };
  OpenFeed out{note, nullptr, std::move(room)};
  try {
    out.feed = std::make_shared<LiveFeed>(std::move(order));
  } catch (...) {
    remove_files(note.id);
    throw;
  }
  const std::lock_guard lock(mutex_);
  feeds_[note.id] = out;
  return out;
}

std::vector<OpenFeed> FeedBoard::list() const {
  const std::lock_guard lock(mutex_);
  std::vector<OpenFeed> out;
  std::transform(feeds_.rbegin(), feeds_.rend(), std::back_inserter(out),
                 [](const auto& entry) { return entry.second; });
  return out;
}

OpenFeed FeedBoard::get(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto found = feeds_.find(id);
  if (found == feeds_.end()) throw not_found("live feed", id);
  return found->second;
}

OpenFeed FeedBoard::take(const std::string& id) {
  const std::lock_guard lock(mutex_);
  const auto found = feeds_.find(id);
  if (found == feeds_.end()) throw not_found("live feed", id);
  OpenFeed out = std::move(found->second);
  feeds_.erase(found);
  return out;
}

fs::path FeedBoard::raw_log(const std::string& id) const { return folder_.file(kKind, id, ".log"); }

void FeedBoard::remove_files(const std::string& id) const {
  std::error_code ignored;
  for (const char* extension : {".json", ".gpkg", ".log"})
    fs::remove(folder_.file(kKind, id, extension), ignored);
}

std::vector<FeedNote> FeedBoard::left() const {
  std::vector<FeedNote> out;
  for (const std::string& id : folder_.ids(kKind, ".json")) {
    try {
      std::ifstream file(folder_.file(kKind, id, ".json"), std::ios::binary);
      out.push_back(note_in(id, ordered_json::parse(file)));
    } catch (const std::exception&) {
      // Not ours, or damaged: the log beside it stays where it is.
    }
  }
  return out;
}

}  // namespace tramline::server
