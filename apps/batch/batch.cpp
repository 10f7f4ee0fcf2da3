#include "batch/batch.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "batch/digest.h"
#include "batch/summary.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/plan_metadata.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

/// Rings of one feature as bytes.
void add_feature(const RawFeature& feature, Digest& digest) {
  digest.add(&feature.fid, sizeof feature.fid);
  digest.add(feature.id + '\n');
  for (const RawPolygon& polygon : feature.polygons)
    for (const RawRing& ring : polygon.rings) {
      const std::size_t corners = ring.points.size();
      digest.add(&corners, sizeof corners);
      for (const Point& point : ring.points) {
        digest.add(&point.x, sizeof point.x);
        digest.add(&point.y, sizeof point.y);
      }
    }
}

/// Whether SQLite keeps changes of a file in a log beside it that are not in the file yet.
bool has_a_log(const std::string& file) {
  std::error_code none;
  const auto bytes = std::filesystem::file_size(file + "-wal", none);
  return !none && bytes > 0;
}

/// Of all files that the parcels are read from; where there are none, as in a database, or changes are not in
/// them yet, of the parcels themselves.
std::string digest_of_parcels(io::FeatureStream& stream) {
  Digest out;
  const std::vector<std::string> files = stream.files();
  for (const std::string& file : files) {
    out.add(std::filesystem::path(file).filename().string() + '\n');
    out.add_file(file);
  }
  const bool all_written =
      std::none_of(files.begin(), files.end(), [](const std::string& file) { return has_a_log(file); });
  if (!files.empty() && all_written) return out.text();
  constexpr long long kAtATime = 1000;
  for (long long first = 0; first < stream.count(); first += kAtATime)
    for (const RawLayer& layer : stream.read(first, kAtATime).layers)
      for (const RawFeature& feature : layer.features) add_feature(feature, out);
  return out.text();
}

/// Of machine, objective and settings to the last bit, and of the files beside them.
std::string digest_of_request(const ChunkRequest& request) {
  Plan asked;
  asked.machine = request.asked.machine();
  asked.objective = request.asked.objective();
  asked.settings = request.asked.settings_on(asked.field);
  std::string text;
  for (const auto& [key, value] : io::metadata_of(asked)) text += key + '=' + value + '\n';
  const PlanOptions& o = request.plan;
  for (const std::string& word : {o.ab, o.guide_file, o.guide_where, o.start, o.end}) text += word + '\n';
  Digest out;
  out.add(text);
  for (const std::string& file : {o.guide_file, o.start, o.end})
    if (!file.empty()) out.add_file(file);
  return out.text();
}

ordered_json description(const BatchRequest& request, const ChunkRequest& chunk, io::FeatureStream& parcels) {
  return {{"format_version", 1},
          {"program", TRAMLINE_VERSION},
          {"parcels", request.field.file},
          {"layer", request.field.layer},
          {"where", request.field.where},
          {"crs", request.field.crs},
          {"fields", parcels.count()},
          {"fields_per_chunk", request.fields_per_chunk},
          {"contents", digest_of_parcels(parcels)},
          {"options", digest_of_request(chunk)}};
}

io::VectorQuery query_of(const FieldOptions& options) {
  io::VectorQuery out;
  out.file = options.file;
  out.layer = options.layer;
  out.where = options.where;
  return out;
}

}  // namespace

Batch::Batch(BatchRequest request, BatchFolder::Start start)
    : request_(std::move(request)),
      chunk_{request_.field, request_.plan, AskedPlans(request_.plan)},
      folder_(request_.folder),
      stream_(query_of(request_.field)) {
  folder_.begin(description(request_, chunk_, stream_), start);
}

long long Batch::chunks() const { return (fields() + per_chunk() - 1) / per_chunk(); }

long long Batch::fields_in(long long chunk) const {
  return std::min(per_chunk(), fields() - chunk * per_chunk());
}

std::vector<long long> Batch::missing() const {
  std::vector<long long> out;
  for (long long chunk = 0; chunk < chunks(); ++chunk)
    if (!folder_.is_finished(chunk)) out.push_back(chunk);
  return out;
}

RawDataset Batch::features_of(long long chunk) {
  const std::lock_guard alone(reading_);
  RawDataset out = stream_.read(chunk * per_chunk(), fields_in(chunk));
  const long long read = out.layers.empty() ? 0 : std::ssize(out.layers.front().features);
  if (read != fields_in(chunk))
    throw failure(fmt::format("'{}' has fewer features than when the batch began: has it been changed since?",
                              request_.field.file));
  return out;
}

ChunkCounts Batch::work_on(long long chunk) {
  return work_on_chunk(chunk_, features_of(chunk), folder_, chunk);
}

void Batch::work(int threads, const Told& told) {
  const auto all = static_cast<std::size_t>(
      threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, all);
  const std::vector<long long> missing = this->missing();
  std::size_t next = 0;
  std::mutex telling;
  struct Read {
    long long chunk = 0;
    RawDataset features;
  };
  const auto read = [&](tbb::flow_control& flow) {
    if (next == missing.size()) {
      flow.stop();
      return std::make_shared<Read>();
    }
    const long long chunk = missing[next++];
    return std::make_shared<Read>(Read{chunk, features_of(chunk)});
  };
  const auto plan = [&](const std::shared_ptr<Read>& from) {
    const ChunkCounts counts = work_on_chunk(chunk_, std::move(from->features), folder_, from->chunk);
    const std::lock_guard alone(telling);
    if (told) told(from->chunk, counts);
  };
  tbb::task_arena arena(static_cast<int>(all));
  arena.execute([&] {
    tbb::parallel_pipeline(
        all, tbb::make_filter<void, std::shared_ptr<Read>>(tbb::filter_mode::serial_in_order, read) &
                 tbb::make_filter<std::shared_ptr<Read>, void>(tbb::filter_mode::parallel, plan));
  });
}

ordered_json Batch::finish() const {
  if (const std::vector<long long> left = missing(); !left.empty())
    throw failure(
        fmt::format("{} chunks of '{}' are not finished: go on with --resume", left.size(), request_.folder));
  folder_.tidy();
  return write_summary(folder_, chunks());
}

}  // namespace tramline::app
