#pragma once
// The QGIS styles of the layers of a tramline file.

#include <ogrsf_frmts.h>

#include <string>
#include <vector>

namespace tramline::io {

struct LayerStyle {
  const char* layer;
  std::string about;  ///< one sentence for people
  std::string qml;
};

/// Adds the table layer_styles, where QGIS looks for a default style of each layer. Failures are left to the
/// GdalErrors of the caller.
void write_styles(GDALDataset& file, const std::vector<LayerStyle>& styles);

}  // namespace tramline::io
