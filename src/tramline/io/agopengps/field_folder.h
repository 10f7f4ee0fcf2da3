#pragma once
// Reads field folders of AgOpenGPS: the field, and lines to drive along.

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "tramline/io/agopengps/local_plane.h"
#include "tramline/model/raw_feature.h"

namespace tramline::io {

/// A folder with a Field.txt that says where the field was started. Names of files are found in any case.
class FieldFolder {
 public:
  /// nullopt where the path is no such folder. Throws bad_input, naming file and line, where the start is no
  /// position.
  static std::optional<FieldFolder> open(const std::string& path);

  /// The path of a file in it; nullopt where there is none of that name.
  std::optional<std::string> file(const std::string& name) const;
  const LocalPlane& plane() const { return plane_; }
  const std::string& path() const { return path_; }
  /// The name of the folder, which is that of the field.
  std::string field_name() const;

 private:
  FieldFolder(std::string path, std::map<std::string, std::string> names, LocalPlane plane)
      : path_(std::move(path)), names_(std::move(names)), plane_(plane) {}

  std::string path_;
  std::map<std::string, std::string> names_;  ///< in small letters, with the actual names
  LocalPlane plane_;
};

/// Layer "fields": one feature, named after the folder, with the outer boundary of Boundary.txt and the inner
/// ones as holes. Those to be driven through belong to the field; they are listed in `skipped`. WGS 84.
/// Throws bad_input, naming file and line, where it cannot be read or holds no boundary.
RawDataset field_in(const FieldFolder& folder);

/// Layer "guides": the tracks of TrackLines.txt, whose attribute "role" is "track" since they are the middle
/// of one, and the headland lines of Headlines.txt, all called by their names; the ids of lines that are
/// called alike have a number, "AB 90 (2)". Those that are no line, such as pivots, are listed in `skipped`.
/// WGS 84. Throws bad_input as field_in().
RawDataset guides_in(const FieldFolder& folder);

}  // namespace tramline::io
