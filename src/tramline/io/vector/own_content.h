#pragma once
// Refuses files that refer the reader to data elsewhere.

#include <string>

namespace tramline::io {

/// Checks a file before a driver of GDAL reads it. `name` is GDAL's name of it, also within an archive;
/// `shown` is the name for messages. Throws bad_input, naming what it points at and what to do, for GeoJSON
/// whose "crs" is a link, a url or a path, for XML with a document type (entities, definitions elsewhere),
/// for VRT and other descriptions of data elsewhere, for MapInfo tables made of other tables, for SQLite with
/// virtual tables that read other files, and for data that drivers would keep whole: KML of more than 48 MiB,
/// and JSON of more than 64 MB that is not a collection of features. Folders and files of other kinds are
/// accepted. O(size of the file).
void require_own_content(const std::string& name, const std::string& shown);

}  // namespace tramline::io
