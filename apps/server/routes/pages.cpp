// What a browser shows.

#include "server/routes/routes.h"

namespace tramline::server {

void add_page_routes(Router& router, App&) {
  router.get("/", [](const Call&, httplib::Response& response) {
    response.set_content("<!doctype html><title>tramline</title><p>The page is not part of this build.</p>",
                         "text/html; charset=utf-8");
  });
}

}  // namespace tramline::server
