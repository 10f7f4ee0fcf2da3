#pragma once
// Finds the name under which GDAL opens a file that the user has named.

#include <cstddef>
#include <string>
#include <vector>

namespace tramline::io {

/// Whether it is a database string such as "PG:dbname=farm" rather than a path.
bool is_database_string(const std::string& file);

/// Whether it is a folder, on disk or in a zip.
bool is_folder(const std::string& name);

/// The string with any password masked, for messages.
std::string shown_name(const std::string& file);

/// The largest expanded size of a gzipped file, or of a vector file in a zip; larger ones are refused.
inline constexpr std::size_t kMostExpandedDataset = std::size_t{1} << 30;

/// The names GDAL can open for `file`: the file itself (expanded where it is a .gz), or for a .zip each
/// vector dataset inside, in any folder (the Shapefiles of one folder are one dataset). Throws bad_input when
/// the file does not exist, or when the zip cannot be read or holds no vector file, and where
/// a .gz, or a vector file in the zip, expands beyond kMostExpandedDataset.
std::vector<std::string> locate_datasets(const std::string& file);

}  // namespace tramline::io
