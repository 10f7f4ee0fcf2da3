#include "batch/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "report/report_parts.h"
#include "tramline/geometry/error.h"
#include "tramline/io/geopackage/whole_file.h"
#include "tramline/render/histogram/draw_histogram.h"

namespace tramline::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::array kFigures{"area_m2",        "subfields",  "tracks",       "turns", "stops",
                              "track_length_m", "overlap_m2", "uncovered_m2", "cost"};
constexpr std::array kWholeFigures{"hours", "litres", "euros"};
constexpr std::array kSums{"area_m2", "track_length_m", "overlap_m2", "uncovered_m2"};
constexpr double kSquareMetresPerHectare = 1e4;

/// A text file that gets its name once it is whole.
class TextFile {
 public:
  explicit TextFile(fs::path file)
      : file_(std::move(file)),
        beside_(file_.parent_path() / ("." + file_.filename().string() + ".partial")) {
    stream_.open(beside_, std::ios::binary | std::ios::trunc);
  }
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;
  ~TextFile() {
    std::error_code ignored;
    fs::remove(beside_, ignored);
  }

  void add(const std::string& line) { stream_ << line << '\n'; }
  void keep() {
    stream_.close();
    std::error_code error;
    if (stream_) fs::rename(beside_, file_, error);
    if (!stream_ || error)
      throw failure(
          fmt::format("'{}' could not be written: is its folder writable and not full?", file_.string()));
  }

 private:
  fs::path file_, beside_;
  std::ofstream stream_;
};

std::string number(const ordered_json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() || found->is_null() ? "" : found->dump();
}

class Summary {
 public:
  explicit Summary(const BatchFolder& folder)
      : folder_(folder), fields_(folder.file("fields.csv")), refused_(folder.file("refused.csv")) {
    std::string head = "field_id,key";
    for (const char* key : kFigures) head += std::string(",") + key;
    for (const char* key : kWholeFigures) head += std::string(",") + key;
    fields_.add(head);
    refused_.add("field_id,key,error");
    for (const char* key : kSums) sums_[key] = 0.0;
  }

  void add(const ordered_json& line) {
    if (line.contains("skipped") && !line.contains("field_id")) {
      skipped_ += line["skipped"].size();
      return;
    }
    const std::string names = csv_text(line.value("field_id", "")) + "," + csv_text(line.value("key", ""));
    if (line.contains("error")) {
      ++refused_count_;
      return refused_.add(names + "," + csv_text(line.value("error", "")));
    }
    add_field(line, names);
  }

  ordered_json finish() {
    fields_.keep();
    refused_.keep();
    ordered_json out{{"fields", planned_ + refused_count_},
                     {"planned", planned_},
                     {"refused", refused_count_},
                     {"skipped", skipped_}};
    for (const auto& item : sums_.items()) out[item.key()] = item.value();
    render::draw_histogram(
        {whole_ ? "What the work costs" : "Overlap and uncovered land",
         fmt::format("{} fields planned, {} refused", planned_, refused_count_),
         whole_ ? "euros per hectare" : "land worked twice or missed, % of the field", std::move(values_)},
        folder_.file("histogram.png"));
    const std::string text = json_text(out, 2) + '\n';
    io::write_whole(folder_.file("summary.json"), std::as_bytes(std::span(text)));
    return out;
  }

 private:
  void add_field(const ordered_json& line, const std::string& names) {
    ++planned_;
    const ordered_json whole = line.value("whole_cost", ordered_json::object());
    std::string row = names;
    for (const char* key : kFigures) row += "," + number(line, key);
    for (const char* key : kWholeFigures) row += "," + number(whole, key);
    fields_.add(row);
    for (const char* key : kSums) sums_[key] = sums_[key].get<double>() + line.at(key).get<double>();
    const double area_m2 = line.at("area_m2").get<double>();
    if (!whole.empty()) {
      whole_ = true;
      for (const char* key : kWholeFigures) sums_[key] = sums_.value(key, 0.0) + whole.at(key).get<double>();
      values_.push_back(whole.at("euros").get<double>() * kSquareMetresPerHectare / area_m2);
    } else {
      values_.push_back(100 * (line.at("overlap_m2").get<double>() + line.at("uncovered_m2").get<double>()) /
                        area_m2);
    }
    values_.back() = std::max(0.0, values_.back());
  }

  const BatchFolder& folder_;
  TextFile fields_, refused_;
  std::size_t planned_ = 0, refused_count_ = 0, skipped_ = 0;
  bool whole_ = false;
  ordered_json sums_;
  std::vector<double> values_;
};

}  // namespace

ordered_json write_summary(const BatchFolder& folder, long long chunks) {
  Summary summary(folder);
  for (long long chunk = 0; chunk < chunks; ++chunk) {
    const fs::path file = folder.lines_of(chunk);
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw failure(fmt::format("'{}' cannot be read", file.string()));
    std::string text;
    for (long long row = 1; std::getline(stream, text); ++row) {
      try {
        summary.add(ordered_json::parse(text));
      } catch (const ordered_json::exception&) {
        throw bad_input(fmt::format("line {} of '{}' is damaged: delete the file and go on with --resume",
                                    row, file.string()));
      }
    }
  }
  return summary.finish();
}

}  // namespace tramline::app
