#include "tramline/io/field/write_field.h"

#include "tramline/io/field/field_file.h"
#include "tramline/io/field/field_layers.h"
#include "tramline/io/field/field_styles.h"
#include "tramline/io/field/field_values.h"
#include "tramline/io/geopackage/metadata_table.h"
#include "tramline/io/geopackage/remarks.h"
#include "tramline/io/geopackage/write_geopackage.h"

namespace tramline::io {
namespace {

Metadata metadata_of(const Field& field, const Metadata& remarks) {
  Metadata out;
  const FieldKeyWriter writer(out);
  each_field_value(field, writer);
  out[kInputCrsKey] = field.source.input_crs;
  leave_folders_out(out);
  out["format"] = kFieldFormat;
  out["format_version"] = std::to_string(kFieldVersion);
  add_remarks(remarks, out);
  return out;
}

}  // namespace

void write_field(const Field& field, const std::filesystem::path& path, const Metadata& remarks) {
  write_geopackage(path, kFieldFile, field.frame, [&](const Target& target) {
    write_field_layers(target, field);
    write_metadata_table(target, metadata_of(field, remarks));
    write_styles(target.file, styles_of_field());
  });
}

}  // namespace tramline::io
