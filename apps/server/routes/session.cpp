// The token, kept by the browser.

#include <fmt/format.h>

#include "server/http/gate.h"
#include "server/http/http_error.h"
#include "server/input/json_input.h"
#include "server/routes/routes.h"

namespace tramline::server {

void add_session_routes(Router& router, App& app) {
  router.post(api("/session"), [&app](const Call& call, httplib::Response& response) {
    const nlohmann::ordered_json json = call.json();
    const std::string token = JsonInput(json, "", {"token"}).text("token");
    if (!app.settings.token.empty() && !same_secret(token, app.settings.token))
      throw HttpError(
          Fault::kForbidden,
          "this is not the token of this server; open the address that was printed when it started");
    response.set_header("Set-Cookie", fmt::format("tramline_token={}; Path=/; HttpOnly; SameSite=Strict",
                                                  app.settings.token));
    answer(response, {{"ok", true}});
  });
}

}  // namespace tramline::server
