#pragma once
// Bodies of answers that are compressed where the client takes that.

#include <httplib.h>

#include <string>

namespace tramline::server {

/// Whether the client takes bodies that are compressed with gzip.
bool takes_gzip(const httplib::Request& request);

/// Sends GeoJSON, whose type cpp-httplib does not compress by itself. O(size).
void send_geojson(const httplib::Request& request, httplib::Response& response, std::string text);

}  // namespace tramline::server
