#include "tramline/io/field/read_field.h"

#include "tramline/io/field/field_file.h"
#include "tramline/io/field/field_layers.h"
#include "tramline/io/field/field_values.h"
#include "tramline/io/geopackage/local_crs.h"
#include "tramline/io/geopackage/metadata_table.h"
#include "tramline/io/geopackage/remarks.h"

namespace tramline::io {

StoredField read_field(const std::filesystem::path& path) {
  GdalErrors errors;
  Rows file(path, kFieldFile, errors);
  const Metadata metadata = read_metadata_table(file);
  const FieldKeyReader reader(metadata, path, kFieldFile);
  if (reader.text("format") != kFieldFormat) throw reader.wrong("format", "'tramline field'");
  int version = 0;
  reader("format_version", version);
  if (version != kFieldVersion)
    throw reader.wrong("format_version", "1: read it with the tramline that wrote it");
  StoredField out;
  each_field_value(out.field, reader);
  out.field.source.input_crs = reader.text(kInputCrsKey);
  file.shift_by(offset_of(out.field.frame));
  read_field_layers(file, path, kFieldFile, out.field);
  out.remarks = remarks_in(metadata);
  return out;
}

}  // namespace tramline::io
