// What a browser shows.

#include <string>

#include "page/page_asset.h"
#include "page/page_policy.h"
#include "server/http/packed.h"
#include "server/routes/routes.h"

namespace tramline::server {
namespace {

// As a stream of known length: whole bodies are compressed by cpp-httplib, once more, at every request.
void send(std::string_view bytes, std::string_view type, httplib::Response& response) {
  response.set_content_provider(bytes.size(), std::string(type),
                                [bytes](std::size_t from, std::size_t length, httplib::DataSink& sink) {
                                  return sink.write(bytes.data() + from, length);
                                });
}

void show(const tramline::app::Asset& asset, const std::string& policy, const httplib::Request& request,
          httplib::Response& response) {
  response.set_header("ETag", std::string(asset.etag));
  response.set_header("Cache-Control", asset.lasting ? "public, max-age=31536000, immutable" : "no-cache");
  response.set_header("Content-Security-Policy", policy);
  response.set_header("X-Content-Type-Options", "nosniff");
  response.set_header("Referrer-Policy", "no-referrer");
  response.set_header("Vary", "Accept-Encoding");
  if (request.get_header_value("If-None-Match") == asset.etag) {
    response.status = 304;
    return;
  }
  const bool packed = !asset.gzip.empty() && takes_gzip(request);
  if (packed) response.set_header("Content-Encoding", "gzip");
  send(packed ? asset.gzip : asset.content, asset.content_type, response);
}

}  // namespace

void add_page_routes(Router& router, App& app) {
  const std::string policy = tramline::app::page_policy(app.settings.tiles);
  for (const tramline::app::Asset& asset : tramline::app::page_assets()) {
    const Handler handler = [asset, policy](const Call& call, httplib::Response& response) {
      show(asset, policy, call.request(), response);
    };
    router.get(std::string(asset.path), handler);
    if (asset.path == "/index.html") router.get("/", handler);
  }
}

}  // namespace tramline::server
