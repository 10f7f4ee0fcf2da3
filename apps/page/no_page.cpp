#include <array>

#include "page/page_asset.h"

namespace tramline::app {
namespace {

constexpr std::string_view kText =
    "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>tramline</title>"
    "<p>This tramline was built without its page. Its API is at <a href=\"/api/v1\">/api/v1</a>; for the "
    "page, "
    "configure with -DTRAMLINE_PAGE=ON and build again.</p></html>\n";

constexpr std::array kAssets = {
    Asset{"/index.html", kText, "", "text/html; charset=utf-8", "\"no-page\"", false}};

}  // namespace

std::span<const Asset> page_assets() { return kAssets; }

}  // namespace tramline::app
