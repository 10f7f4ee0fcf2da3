// What this server is, and what it takes.

#include "server/openapi.h"
#include "server/routes/routes.h"

namespace tramline::server {

using nlohmann::ordered_json;

namespace {

std::string tiles_of(const App& app) {
  return app.background ? api("/background/{z}/{x}/{y}") : app.settings.tiles;
}

/// Whom the picture of the land is from; of a file that nobody named otherwise its own name.
std::string source_of(const App& app) {
  const std::string& named = app.settings.tiles_attribution;
  return app.background && named.empty() ? app.background->name() : named;
}

/// Where the tiles of a file lie, and their levels; null of tiles from elsewhere, of which that is not known.
ordered_json land_shown(const App& app) {
  if (app.background == nullptr) return {};
  const Box& box = app.background->lonlat_deg();
  return {{"bbox", {box.min_x, box.min_y, box.max_x, box.max_y}},
          {"first_zoom", app.background->first_zoom()},
          {"last_zoom", app.background->last_zoom()}};
}

}  // namespace

void add_about_routes(Router& router, App& app) {
  const auto about = [&app](const Call&, httplib::Response& response) {
    const auto text_or_null = [](const std::string& text) {
      return text.empty() ? ordered_json() : ordered_json(text);
    };
    answer(response, {{"name", "tramline"},
                      {"version", TRAMLINE_VERSION},
                      {"limits",
                       {{"upload_bytes", app.settings.limits.upload_bytes},
                        {"streams", app.settings.limits.streams},
                        {"jobs", app.settings.limits.jobs}}},
                      {"tiles", text_or_null(tiles_of(app))},
                      {"tiles_attribution", text_or_null(source_of(app))},
                      {"tiles_of", land_shown(app)}});
  };
  router.get(kApi, about);
  router.get(api("/"), about);
  router.get(api("/openapi.json"), [](const Call&, httplib::Response& response) {
    response.set_content(openapi().data(), openapi().size(), "application/json");
  });
}

}  // namespace tramline::server
