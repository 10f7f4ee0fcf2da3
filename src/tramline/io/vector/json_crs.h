#pragma once
// The coordinate reference system that GeoJSON declares by "crs".

#include <functional>
#include <iosfwd>
#include <string>

namespace tramline::io {

/// Calls `take` with the type ("name", "link" …) and the name, href or url of each object "crs", wherever it
/// is in the values (one, or one after another). Ends without an error where the text is not JSON. O(n), and
/// a few bytes of memory for each level of nesting.
void each_json_crs(std::istream& text,
                   const std::function<void(const std::string& type, const std::string& place)>& take);

/// Skips white space and the separator of RFC 8142 between the values of a sequence. False at the end.
bool skip_to_json_value(std::istream& text);

}  // namespace tramline::io
