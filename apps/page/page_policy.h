#pragma once
// The content security policy of the page.

#include <string>
#include <string_view>

namespace tramline::app {

/// The value of the header Content-Security-Policy for every file of the page: scripts, workers, styles and
/// requests from the server itself and nowhere else, but for raster tiles, where `tiles` is an address such
/// as "https://tile.example.org/{z}/{x}/{y}.png" (empty: no tiles). Of that address only scheme, host and
/// port are allowed; an address without scheme and host, or with characters that a policy cannot hold, allows
/// nothing.
std::string page_policy(std::string_view tiles);

}  // namespace tramline::app
