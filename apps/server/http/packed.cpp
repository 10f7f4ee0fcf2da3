#include "server/http/packed.h"

#include <zlib.h>

#include <cstddef>
#include <memory>
#include <utility>

#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

constexpr const char* kGeoJson = "application/geo+json";
/// Less is not worth the work of both sides.
constexpr std::size_t kWorthPacking = 1024;
/// Shapes are many alike numbers: more effort saves little.
constexpr int kLevel = 6;
constexpr int kGzipWindow = 15 + 16;
constexpr int kMemoryLevel = 8;

std::string gzipped(const std::string& text) {
  z_stream stream{};
  if (deflateInit2(&stream, kLevel, Z_DEFLATED, kGzipWindow, kMemoryLevel, Z_DEFAULT_STRATEGY) != Z_OK)
    throw failure("the answer could not be compressed; is there too little memory?");
  std::string out(deflateBound(&stream, static_cast<uLong>(text.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int ended = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  if (ended != Z_STREAM_END) throw failure("the answer could not be compressed");
  return out;
}

void send_packed(const httplib::Request& request, httplib::Response& response, std::string text,
                 const std::string& type) {
  response.set_header("Vary", "Accept-Encoding");
  auto body = std::make_shared<std::string>(std::move(text));
  if (body->size() >= kWorthPacking && takes_gzip(request)) {
    response.set_header("Content-Encoding", "gzip");
    *body = gzipped(*body);
  }
  response.set_content_provider(body->size(), type,
                                [body](std::size_t from, std::size_t size, httplib::DataSink& sink) {
                                  return sink.write(body->data() + from, size);
                                });
}

}  // namespace

bool takes_gzip(const httplib::Request& request) {
  return request.get_header_value("Accept-Encoding").find("gzip") != std::string::npos;
}

void send_geojson(const httplib::Request& request, httplib::Response& response, std::string text) {
  send_packed(request, response, std::move(text), kGeoJson);
}

void pack_body(const httplib::Request& request, httplib::Response& response) {
  constexpr int kFault = 400;
  // Faults are short, and go through cpp-httplib's handler of errors, which looks at the body.
  if (response.body.empty() || response.status >= kFault) return;
  const std::string type = response.get_header_value("Content-Type");
  response.headers.erase("Content-Type");  // the provider sets it again
  send_packed(request, response, std::exchange(response.body, {}), type);
}

}  // namespace tramline::server
