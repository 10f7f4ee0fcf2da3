#include "tramline/io/geopackage/layer_styles.h"

#include "tramline/io/geopackage/table.h"
#include "tramline/io/geopackage/time_stamp.h"

namespace tramline::io {

/// The columns are those QGIS makes itself. It takes a default only where the schema is an empty text, not
/// NULL.
void write_styles(GDALDataset& file, const std::vector<LayerStyle>& styles) {
  Table table(file, "layer_styles", wkbNone, nullptr,
              {text("f_table_catalog"),
               text("f_table_schema"),
               text("f_table_name"),
               text("f_geometry_column"),
               text("styleName"),
               text("styleQML"),
               text("styleSLD"),
               flag("useAsDefault"),
               text("description"),
               text("owner"),
               text("ui"),
               {"update_time", OFTDateTime}},
              "id");
  const std::string nothing, now = time_stamp();
  for (const LayerStyle& style : styles)
    table.add(nullptr,
              {nothing, nothing, std::string(style.layer), std::string("geom"), std::string("tramline"),
               style.qml, nothing, true, style.about, std::string("tramline"), Cell(), now});
}

}  // namespace tramline::io
