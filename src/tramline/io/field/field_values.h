#pragma once
// The data of a field without shapes, as keys and values of the table `metadata`.

#include <string>
#include <vector>

#include "tramline/io/geopackage/key_values.h"
#include "tramline/model/field.h"

namespace tramline::io {

/// Visits the keys of a frame.
template <class FrameOrConst, class Visitor>
void each_frame_value(FrameOrConst& frame, Visitor&& visit) {
  visit("frame.geodetic", frame.geodetic);
  visit("frame.origin_lon_deg", frame.origin_lon_deg);
  visit("frame.origin_lat_deg", frame.origin_lat_deg);
  visit("frame.origin_x_m", frame.origin_x_m);
  visit("frame.origin_y_m", frame.origin_y_m);
}

/// Visits all keys, in the same order for writers (const field) and readers.
template <class FieldOrConst, class Visitor>
void each_field_value(FieldOrConst& field, Visitor&& visit) {
  visit("field.id", field.id);
  visit("field.source.file", field.source.file);
  visit("field.source.layer", field.source.layer);
  visit("field.source.fid", field.source.fid);
  visit("field.source.part", field.source.part);
  visit("field.source.crs", field.source.crs);
  visit("field.source.obstacles_file", field.source.obstacles_file);
  visit("field.source.obstacle_size_m", field.source.obstacle_size_m);
  visit("field.source.passable_file", field.source.passable_file);
  visit("field.repairs", field.repairs);
  visit("field.warnings", field.warnings);
  each_frame_value(field.frame, visit);
}

/// A key added later than the others: files without it are valid too.
inline constexpr const char* kInputCrsKey = "field.source.input_crs";

/// Removes the folders of source files: a file must not contain paths of the machine it was made on. To be
/// called when all keys are there.
void leave_folders_out(Metadata& metadata);

class FieldKeyWriter : public KeyWriter {
 public:
  using KeyWriter::KeyWriter;
  using KeyWriter::operator();
  void operator()(const std::string& key, const std::vector<Repair>& repairs) const;
};

class FieldKeyReader : public KeyReader {
 public:
  using KeyReader::KeyReader;
  using KeyReader::operator();
  void operator()(const std::string& key, std::vector<Repair>& repairs) const;
};

}  // namespace tramline::io
