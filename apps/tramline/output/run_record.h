#pragma once
// What a run over many fields has finished, noted beside its output, so that another can go on from there.

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tramline::app {

/// What became of one field.
struct FieldResult {
  nlohmann::ordered_json json;
  std::string text;                ///< for people; of a refused field the sentence
  std::vector<std::string> files;  ///< that were written
  bool refused = false;
};

/// A file of one JSON object per line. A line is appended in one write once all files of its field have their
/// names, so whenever the run is killed the record says of no field more than there is; a last line that was
/// cut off is passed over.
class RunRecord {
 public:
  /// Goes on with the record in `file`, where `resume` and there is one; else with none, and takes away an
  /// older one. Throws Error(kFailure) where the file cannot be read or changed.
  enum class Start { kAnew, kResume };
  RunRecord(std::filesystem::path file, Start start);

  /// The field of this key as finished by a former run from the same (`made_from`), its files still being
  /// there; nullptr where there is none.
  const FieldResult* finished(const std::string& key, const std::string& made_from) const;
  /// Does as if nothing had been finished whose result lies in `file`.
  void forget_those_in(const std::string& file);
  /// Throws Error(kFailure) where the disk does not take it.
  void add(const std::string& key, const std::string& made_from, const FieldResult& result);

 private:
  struct Entry {
    std::string made_from;
    FieldResult result;
  };
  void read();

  std::filesystem::path file_;
  std::map<std::string, Entry> entries_;
};

}  // namespace tramline::app
