#pragma once
// The coordinate reference system that GeoJSON declares by "crs".

#include <functional>
#include <iosfwd>
#include <string>

namespace tramline::io {

/// Calls `take` with the type ("name", "link" …) and the name, href or url of each object "crs", wherever in
/// the values (one, or one after another) it stands. Ends quietly where the text is no JSON. O(n), and a few
/// bytes of memory for each level of nesting.
void each_json_crs(std::istream& text,
                   const std::function<void(const std::string& type, const std::string& place)>& take);

/// Between the values of a sequence: passes by white space and the mark that RFC 8142 puts before each. False
/// at the end.
bool skip_to_json_value(std::istream& text);

}  // namespace tramline::io
