#pragma once
// The folder of a batch: what it is a batch of, and its chunks.
//
//   batch.json             what is planned and how; another process that works here has to plan the same
//   chunks/000001.gpkg     the plans of the first fields (none where all were refused)
//                          and 000001-2.gpkg where they lie in several parts of the world
//   chunks/000001.jsonl    a line for each field; it is there once the chunk is finished
//   fields.csv, refused.csv, histogram.png, summary.json    at the end

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace tramline::app {

class BatchFolder {
 public:
  /// kResume: goes on where a former batch ended, if there is one.
  enum class Start { kAnew, kResume };

  explicit BatchFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Makes the folder, or recognises it. `batch`: what has to be equal for its chunks to be of use. Throws
  /// Error(kBadInput) where the folder is of another batch, and with kAnew where it is of any;
  /// Error(kFailure) where it cannot be written.
  void begin(const nlohmann::ordered_json& batch, Start start) const;

  bool is_finished(long long chunk) const;
  /// Writes the line of every field; after that the chunk is finished. Throws Error(kFailure).
  void finish(long long chunk, const std::string& lines) const;

  /// `part`: of a chunk whose fields lie in several parts of the world, counted from 0.
  std::filesystem::path plans_of(long long chunk, std::size_t part) const;
  std::filesystem::path lines_of(long long chunk) const;
  /// Removes what killed processes have left half-written. To be called when all chunks are finished.
  void tidy() const;
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

}  // namespace tramline::app
