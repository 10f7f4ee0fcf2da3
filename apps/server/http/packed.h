#pragma once
// Bodies of answers that are compressed where the client takes that.

#include <httplib.h>

#include <string>

namespace tramline::server {

/// Whether the client takes bodies that are compressed with gzip.
bool takes_gzip(const httplib::Request& request);

/// Sends GeoJSON, whose type cpp-httplib does not compress by itself. O(size).
void send_geojson(const httplib::Request& request, httplib::Response& response, std::string text);

/// Makes the whole body of an answer one of known length, packed where that is worth it. cpp-httplib would
/// compress it with all the effort that brotli knows, which takes a minute for a register. Without a
/// body, and of faults, nothing changes. O(size).
void pack_body(const httplib::Request& request, httplib::Response& response);

}  // namespace tramline::server
