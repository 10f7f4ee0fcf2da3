#pragma once
// Selection of fields by the user's options, and the selected fields.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tramline/model/field.h"
#include "tramline/model/raw_feature.h"

namespace tramline::app {

/// The options as typed; empty where the user gave none.
struct FieldOptions {
  std::string file, layer, where, crs, obstacles_file, passable_file;
  std::string id{};                ///< only the field of this id or key (field_key.h), as `info` lists them
  std::optional<long long> fid{};  ///< only the feature with this number
  bool all = false;
  double obstacle_size_m = 7;
  /// Features that are there already; `file` is what messages call them, and none is read. One layer, with at
  /// least one feature. `layer`, `where` and `fid` are of no account then.
  std::shared_ptr<const RawDataset> in_memory{};
};

/// A feature that cannot be planned.
struct Refusal {
  std::string field_id;
  std::string sentence;  ///< the error of a run on this feature alone
  long long fid = -1;
};

struct FieldInput {
  std::vector<Field> fields;  ///< in file order
  std::vector<Refusal> refusals;
  std::vector<Skipped> skipped;
  // Facts about the input.
  std::string file;  ///< as the user named it
  std::string driver;
  std::string layer;
  std::string layer_geometry;
  std::string crs;         ///< name of the CRS the coordinates were taken in
  bool crs_given = false;  ///< by --crs, against or without the file's own
  long long features = 0;  ///< how many match; more than were read without --all
};

/// One feature, whose polygons become one field each, or with --all every feature; with --id one field of
/// them, or with both all of that id. Throws bad_input when several features match without --all, listing the
/// first 20 with id and area; when none or several are called what --id says; when a single feature is
/// refused; and for faults of the files. With --all a refused feature is listed and the others are processed.
FieldInput load_fields(const FieldOptions& options);

/// Like load_fields with --all, but reads at most `limit` features and never complains of several. With --id
/// as load_fields.
FieldInput survey_fields(const FieldOptions& options, long long limit);

/// The one field a plan was made from: by layer (or --layer; the only one with polygons where neither is
/// found), feature number and part; --where is ignored. Throws bad_input when the file has no such feature,
/// or the feature no such part, or is refused.
Field load_field(const FieldOptions& options, const FieldSource& source);

}  // namespace tramline::app
