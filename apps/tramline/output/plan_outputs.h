#pragma once
// The files of a run of `plan`: plans, pictures and close-ups, each under its name.

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "output/close_ups.h"
#include "output/run_record.h"
#include "request/output_names.h"
#include "tramline/model/plan.h"

namespace tramline::app {

/// As typed; empty: not wanted.
struct WantedFiles {
  std::string plan, picture, close_ups;
  bool one_file = false;  ///< all plans in the file `plan`
};

/// Names with ids are the same in every run over the same fields, whichever of them are refused. With
/// one_file the plans wait in a folder of their own beside the file, .plan.gpkg.parts, until all are there.
class PlanOutputs {
 public:
  PlanOutputs(WantedFiles wanted, const std::vector<Field>& fields, Naming naming);

  /// Writes all that is wanted of one plan, and gives the names of the files. Throws Error(kFailure).
  std::vector<std::string> write(const Plan& plan);

  /// Where what is finished is noted: beside the first kind of file that is wanted, plan.run.jsonl; empty
  /// where none is.
  std::filesystem::path record_file() const;

  /// With one_file: before the first field, and after the last. `record` is brought up to date: the fields
  /// are in the one file now. Does nothing otherwise.
  void begin(RunRecord& record, const std::vector<std::pair<std::string, std::string>>& made_from,
             RunRecord::Start start);
  void finish(RunRecord& record, const std::vector<std::pair<std::string, std::string>>& made_from);

 private:
  struct Names {
    std::filesystem::path plan, picture;
    std::string close_ups;
  };
  std::filesystem::path parts_folder() const;

  WantedFiles wanted_;
  CloseUps close_ups_;
  std::map<std::string, Names> names_;  ///< by key
  bool whole_is_current_ = false;
};

}  // namespace tramline::app
