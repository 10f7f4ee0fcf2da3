#pragma once
// The land that the user gives beside the field: subfields drawn, land to plan only, land done.

#include <optional>
#include <string>
#include <vector>

#include "tramline/admission/given/read_subfields.h"
#include "tramline/model/plan.h"
#include "tramline/model/report.h"

namespace tramline::app {

/// The options as typed; empty where the user gave none.
struct LandOptions {
  std::string subfields_file, only_file;
  std::vector<std::string> done_files;
};

/// The land of a file whose shapes have a frame of their own, by field where the file has many.
struct DoneLand {
  std::string file;
  std::string field;  ///< key or id of the only field it belongs to; empty: any field it lies in
  std::string field_id;
  Region land;
  LocalFrame frame;
};

/// Which coordinates the files of LandOptions are in: as each says, or plain metres whatever it says, because
/// the user said so of the fields.
enum class LandCrs { kOfEachFile, kPlain };

/// The files of LandOptions, read once for all fields.
class LandFiles {
 public:
  /// `fields_crs`: the CRS of files that do not say theirs, as accepted by Crs. Throws kBadInput.
  LandFiles(const LandOptions& options, const std::string& fields_crs, LandCrs land_crs);

  /// What the files say about a field, in its local metres. Throws kBadInput for a faulty shape.
  GivenLand given_for(const Field& field);

  /// Throws kBadInput where one of the files meets none of the fields that given_for() was asked about.
  /// Returns the shapes that meet none of them.
  std::vector<Skipped> finish(const std::string& fields) const;

 private:
  struct Shapes {
    std::string option;  ///< "--done"
    std::string file;
    std::vector<LooseObstacle> features;
    std::vector<char> used;
  };
  static void require_used(const std::string& option, const std::string& file, bool used,
                           const std::string& fields);

  LandOptions options_;
  std::vector<LooseSubfield> subfields_;
  std::vector<char> used_;
  std::optional<Shapes> only_;
  std::vector<Shapes> done_shapes_;
  std::vector<DoneLand> done_lands_;
  std::vector<char> done_used_;
};

/// A text that differs wherever the given land does.
std::string text_of(const GivenLand& given);

}  // namespace tramline::app
