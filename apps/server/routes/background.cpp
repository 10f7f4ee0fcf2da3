// The picture of the land below the map, from a file of this computer.

#include <charconv>

#include "server/routes/routes.h"
#include "tramline/io/raster/background_map.h"

namespace tramline::server {
namespace {

constexpr int kDeepest = 24;

/// The number of a tile; throws HttpError where it is none below `end`.
int tile_number(const Call& call, const char* part, int end) {
  const std::string& text = call.part(part);
  int number = -1;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || rest != text.data() + text.size() || number < 0 || number >= end)
    throw HttpError(Fault::kNotFound, "there is no such tile");
  return number;
}

}  // namespace

void add_background_routes(Router& router, App& app) {
  router.get(api("/background/{z}/{x}/{y}"), [&app](const Call& call, httplib::Response& response) {
    if (app.background == nullptr)
      throw HttpError(Fault::kNotFound, "there is no background; start the server with --background FILE");
    const int zoom = tile_number(call, "z", kDeepest + 1);
    const int tiles = 1 << zoom;
    const int x = tile_number(call, "x", tiles), y = tile_number(call, "y", tiles);
    if (zoom < app.background->first_zoom())
      throw HttpError(Fault::kNotFound, "the background has no tiles of so far away");
    const io::MapTile tile = app.background->tile(zoom, x, y);
    response.set_header("Cache-Control", "private, max-age=600");
    response.set_content(tile.bytes, tile.type);
  });
}

}  // namespace tramline::server
