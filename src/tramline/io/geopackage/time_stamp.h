#pragma once
// The creation time recorded in files.

#include <ctime>
#include <string>

namespace tramline::io {

/// SOURCE_DATE_EPOCH where that is set, else 1970-01-01: equal plans make equal files. Throws
/// Error(kBadInput) where it is not a whole number of seconds from 1970 to 9999.
std::time_t time_of_files();
/// The same in the format of GDAL's OGR_CURRENT_DATE: "2023-11-14T22:13:20.000Z".
std::string time_stamp();

}  // namespace tramline::io
