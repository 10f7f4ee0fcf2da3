// tramline batch: plans of all fields of a large file, in chunks, resumable.

#include <fmt/format.h>

#include <chrono>
#include <optional>

#include "batch/batch.h"
#include "commands/command.h"
#include "options/batch_options.h"
#include "options/common_options.h"
#include "options/plan_options.h"
#include "output/output_target.h"
#include "output/progress.h"
#include "output/result_output.h"
#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

constexpr const char* kBatchAbout =
    "Plan all fields of a large file in chunks: memory does not grow with the number of fields, and a run "
    "that "
    "was ended goes on where it stopped.";

constexpr const char* kBatchExample =
    "Examples:\n"
    "  tramline batch parcels.gpkg -o plans --width 24 --radius 8\n"
    "  tramline batch parcels.gpkg -o plans --width 24 --radius 8 --resume\n"
    "  tramline batch parcels.gpkg --layer parcels --where \"crop='wheat'\" -o wheat --prices 0.02,0.10,1\n"
    "Each chunk is a GeoPackage of plans and a file of JSON lines in FOLDER/chunks. At the end FOLDER has\n"
    "fields.csv, refused.csv with the reasons, histogram.png and summary.json.\n"
    "On several machines: python3 -m tramline.batch.";

/// How far a run is, and how long it will take.
class Pace {
 public:
  Pace(long long all, long long done_before, bool quiet) : line_(quiet), all_(all), done_(done_before) {}

  void add(long long fields) {
    done_ += fields;
    worked_ += fields;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const double rate = static_cast<double>(worked_) / std::max(seconds, 1e-3);
    line_.show("planned", static_cast<int>(done_), static_cast<int>(all_),
               fmt::format("fields, {:.1f} fields/s, {:.0f} s left", rate,
                           static_cast<double>(all_ - done_) / std::max(rate, 1e-9))
                   .c_str());
  }

 private:
  ProgressLine line_;
  long long all_, done_, worked_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

class BatchCommand : public Command {
 public:
  CommandOptions setup(CLI::App& program) override {
    CommandOptions command(program, "batch", kBatchAbout);
    command.footer(kBatchExample);
    add_batch_options(command, request_, resume_);
    add_report_options(command, json_, "Print the sums as one JSON object.", quiet_);
    command.begin_group("Run");
    add_threads_option(command, threads_);
    command_.emplace(command);
    return command;
  }

  int run() override {
    take_batch_defaults(*command_, request_);
    require_folder(request_.folder, "--output");
    Batch batch(request_, resume_ ? BatchFolder::Start::kResume : BatchFolder::Start::kAnew);
    long long missing = 0;
    for (const long long chunk : batch.missing()) missing += batch.fields_in(chunk);
    {
      Pace pace(batch.fields(), batch.fields() - missing, quiet_);
      batch.work(threads_, [&](long long chunk, const ChunkCounts&) { pace.add(batch.fields_in(chunk)); });
    }
    const nlohmann::ordered_json sums = batch.finish();
    report(sums);
    if (sums["refused"] == 0) return 0;
    return sums["planned"] > 0 ? 3 : 2;
  }

 private:
  void report(const nlohmann::ordered_json& sums) const {
    if (json_) return print_json_line(sums);
    if (quiet_) return;
    print_result(
        fmt::format("planned      {} fields, {} refused (refused.csv says why)\n"
                    "land         {:.4f} ha, overlap {:.1f} m², uncovered {:.1f} m²\n",
                    sums["planned"].get<long long>(), sums["refused"].get<long long>(),
                    sums["area_m2"].get<double>() / 1e4, sums["overlap_m2"].get<double>(),
                    sums["uncovered_m2"].get<double>()));
    if (sums.contains("euros"))
      print_result(fmt::format("whole cost   {:.2f} €, {:.2f} h, {:.1f} l\n", sums["euros"].get<double>(),
                               sums["hours"].get<double>(), sums["litres"].get<double>()));
  }

  BatchRequest request_;
  std::optional<CommandOptions> command_;
  int threads_ = 0;
  bool resume_ = false, json_ = false, quiet_ = false;
};

}  // namespace

std::unique_ptr<Command> make_batch_command() { return std::make_unique<BatchCommand>(); }

}  // namespace tramline::app
