#pragma once
// Opens a path as a dataset of GDAL.

#include <gdal_priv.h>

#include <memory>
#include <string>

#include "tramline/io/gdal/start_gdal.h"

namespace tramline::io {

class GdalMessages;

/// A permission to be kept while the dataset is read: connections are allowed for an address or a database
/// that the user has typed ("PG:dbname=farm", "/vsicurl/https://…"). nullptr for the path of a file.
std::unique_ptr<ConnectionsAllowed> connections_for(const std::string& path);

/// Opens a vector file, a folder of Shapefiles, a database, or the one dataset of a zip; of a zip with
/// several the one with the wanted layer. Throws bad_input when there is no such file, when it is no vector
/// file, when it leads to other
/// files or addresses, and when it is not clear which dataset is meant. GDAL's drivers are registered, and
/// `messages` collects what GDAL says.
GDALDatasetUniquePtr open_dataset(const std::string& path, const std::string& wanted_layer,
                                  GdalMessages& messages);

}  // namespace tramline::io
