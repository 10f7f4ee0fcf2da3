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
  // For whoever has the token already, to open the page on another device.
  router.get(api("/session"), [&app](const Call&, httplib::Response& response) {
    nlohmann::ordered_json addresses = nlohmann::ordered_json::array();
    if (!is_loopback(app.settings.host))
      for (const std::string& address : app.addresses)
        if (address.find("//127.") == std::string::npos && address.find("//[::1]") == std::string::npos &&
            address.find("//localhost") == std::string::npos)
          addresses.push_back(address);
    answer(response, {{"addresses", std::move(addresses)}});
  });
}

}  // namespace tramline::server
