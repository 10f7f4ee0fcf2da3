#pragma once
// The files of the page, embedded in the program.

#include <optional>
#include <span>
#include <string_view>

namespace tramline::app {

/// One file of the page. All views are of static storage.
struct Asset {
  std::string_view path;          ///< "/index.html"
  std::string_view content;       ///< its bytes
  std::string_view gzip;          ///< the same compressed; empty where that is not shorter
  std::string_view content_type;  ///< "text/html; charset=utf-8"
  std::string_view etag;          ///< quoted, from the bytes
  bool lasting = false;  ///< whether the path changes with the content, so that it may be cached for ever
};

/// All files, ascending by path.
std::span<const Asset> page_assets();

/// The file that is served at `path`, "/" being "/index.html"; none where there is no such file. A program
/// built without its page has one file, at "/", that says so. O(log n) in files.
std::optional<Asset> page_asset(std::string_view path);

}  // namespace tramline::app
