#pragma once
// What browsers are told the page may do.

#include <string>
#include <string_view>

namespace tramline::app {

/// The value of the header Content-Security-Policy for every file of the page: scripts, workers, styles and
/// requests from the server itself and nowhere else, but for raster tiles, where `tiles` is an address such
/// as "https://tile.example.org/{z}/{x}/{y}.png" (empty: no tiles). Of that address only scheme, host and
/// port are let in; one without scheme and host, or with characters that a policy cannot hold, lets in
/// nothing.
std::string page_policy(std::string_view tiles);

}  // namespace tramline::app
