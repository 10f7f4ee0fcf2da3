#pragma once
// A file has to hold what it stands for, and may not send the reader elsewhere.

#include <string>

namespace tramline::io {

/// Looks at a file before a driver of GDAL does. `name` is the name GDAL has for it, also within an archive;
/// `shown` the one for messages. Throws bad_input, naming what it points at and what to do, for GeoJSON whose
/// "crs" is a link, a url or a path, for XML with a document type (entities, definitions elsewhere), for VRT
/// and other descriptions of data elsewhere, for MapInfo tables made of other tables, for SQLite with
/// virtual tables that read other files, and for what drivers would keep whole: KML of more than 48 MiB, and
/// JSON of more than 64 MB that is no collection of features. Folders and files of other kinds pass. O(size
/// of the file).
void require_own_content(const std::string& name, const std::string& shown);

}  // namespace tramline::io
