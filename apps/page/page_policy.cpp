#include "page/page_policy.h"

namespace tramline::app {
namespace {

// "https://tile.example.org" of a template of tiles, or nothing.
std::string_view origin_of(std::string_view address) {
  const std::size_t scheme = address.find("://");
  if (scheme == std::string_view::npos) return {};
  if (address.substr(0, scheme) != "http" && address.substr(0, scheme) != "https") return {};
  const std::size_t host = scheme + 3;
  const std::string_view origin = address.substr(0, address.find_first_of("/?#", host));
  constexpr std::string_view kAllowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-:[]";
  if (origin.size() == host || origin.find_first_not_of(kAllowed, host) != std::string_view::npos) return {};
  return origin;
}

}  // namespace

std::string page_policy(std::string_view tiles) {
  std::string sources = "'self' data: blob:";
  const std::string_view origin = origin_of(tiles);
  if (!origin.empty()) sources.append(" ").append(origin);
  std::string policy =
      "default-src 'none'; script-src 'self'; worker-src 'self'; style-src 'self'; font-src 'self'; "
      "manifest-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'; img-src ";
  policy += sources;
  // The map's worker fetches tiles before they are shown as images.
  policy += "; connect-src ";
  policy += sources;
  return policy;
}

}  // namespace tramline::app
