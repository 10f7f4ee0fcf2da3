// What this server is, and what it takes.

#include "server/openapi.h"
#include "server/routes/routes.h"

namespace tramline::server {

using nlohmann::ordered_json;

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
                      {"tiles", text_or_null(app.settings.tiles)},
                      {"tiles_attribution", text_or_null(app.settings.tiles_attribution)}});
  };
  router.get(kApi, about);
  router.get(api("/"), about);
  router.get(api("/openapi.json"), [](const Call&, httplib::Response& response) {
    response.set_content(openapi().data(), openapi().size(), "application/json");
  });
}

}  // namespace tramline::server
