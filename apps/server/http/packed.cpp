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

}  // namespace

bool takes_gzip(const httplib::Request& request) {
  return request.get_header_value("Accept-Encoding").find("gzip") != std::string::npos;
}

void send_geojson(const httplib::Request& request, httplib::Response& response, std::string text) {
  response.set_header("Vary", "Accept-Encoding");
  if (text.size() < kWorthPacking || !takes_gzip(request))
    return response.set_content(std::move(text), kGeoJson);
  response.set_header("Content-Encoding", "gzip");
  const auto packed = std::make_shared<const std::string>(gzipped(text));
  response.set_content_provider(packed->size(), kGeoJson,
                                [packed](std::size_t from, std::size_t size, httplib::DataSink& sink) {
                                  return sink.write(packed->data() + from, size);
                                });
}

}  // namespace tramline::server
