// What this server is, and what it takes.

#include "server/openapi.h"
#include "server/routes/routes.h"

namespace tramline::server {

using nlohmann::ordered_json;

void add_about_routes(Router& router, App& app) {
  const auto about = [&app](const Call&, httplib::Response& response) {
    ordered_json tiles;
    if (!app.settings.tiles.empty()) tiles = app.settings.tiles;
    answer(response, {{"name", "tramline"},
                      {"version", TRAMLINE_VERSION},
                      {"limits",
                       {{"upload_bytes", app.settings.limits.upload_bytes},
                        {"streams", app.settings.limits.streams},
                        {"jobs", app.settings.limits.jobs}}},
                      {"tiles", tiles}});
  };
  router.get(kApi, about);
  router.get(api("/"), about);
  router.get(api("/openapi.json"), [](const Call&, httplib::Response& response) {
    response.set_content(openapi().data(), openapi().size(), "application/json");
  });
}

}  // namespace tramline::server
