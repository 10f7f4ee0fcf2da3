#pragma once
// A batch: plans of all fields of a file, in chunks of which each is worked on by itself.

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "batch/batch_folder.h"
#include "batch/chunk_work.h"
#include "request/field_input.h"
#include "request/plan_request.h"
#include "tramline/io/vector/feature_stream.h"

namespace tramline::app {

struct BatchRequest {
  FieldOptions field;  ///< file, layer, where and crs
  PlanOptions plan;    ///< with its defaults (whole_plan_defaults())
  std::string folder;
  std::size_t fields_per_chunk = 200;
};

/// One process's view of a batch. Several processes may work on the chunks of one folder, each with its own
/// view; a chunk that two of them finish is the same twice.
class Batch {
 public:
  /// Opens the parcels and begins, or recognises, the folder. Throws as FeatureStream, AskedPlans and
  /// BatchFolder::begin(). O(bytes of the parcels): they are read once to recognise them.
  Batch(BatchRequest request, BatchFolder::Start start);

  long long fields() const { return stream_.count(); }
  long long chunks() const;
  /// Those that no process has finished, ascending.
  std::vector<long long> missing() const;
  long long fields_in(long long chunk) const;

  /// Reads and works on one chunk, on the threads of the calling arena. Safe from several threads: reading
  /// waits for its turn. Throws Error(kFailure) where the parcels have fewer features than when they were
  /// opened.
  ChunkCounts work_on(long long chunk);

  /// Told of every chunk when it is finished, one call at a time.
  using Told = std::function<void(long long chunk, const ChunkCounts& counts)>;
  /// Works on all chunks that are missing, with `threads` threads; 0: all cores. At most one chunk for each
  /// thread is in memory.
  void work(int threads, const Told& told);

  /// write_summary() of all chunks. Throws Error(kFailure) where one is missing.
  nlohmann::ordered_json finish() const;

 private:
  long long per_chunk() const { return static_cast<long long>(request_.fields_per_chunk); }
  RawDataset features_of(long long chunk);

  std::mutex reading_;

  BatchRequest request_;
  ChunkRequest chunk_;
  BatchFolder folder_;
  io::FeatureStream stream_;
};

}  // namespace tramline::app
