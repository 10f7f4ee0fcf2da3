#include "server/http/gate.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "server/http/http_error.h"
#include "server/http/router.h"
#include "server/routes/routes.h"
#include "tramline/io/vector/lower_case.h"

namespace tramline::server {
namespace {

constexpr const char* kCookie = "tramline_token=";

bool is_version_6(const std::string& host) { return host.find(':') != std::string::npos; }

std::string with_port(const std::string& host, int port) {
  return is_version_6(host) ? fmt::format("[{}]:{}", io::lower_case(host), port)
                            : fmt::format("{}:{}", io::lower_case(host), port);
}

/// An address in numbers: nobody else's name can be led to it.
bool is_numeric(const std::string& host) {
  if (host.starts_with('[')) return true;
  return !host.empty() && host.find_first_not_of("0123456789.") == std::string::npos;
}

std::string own_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : std::string();
}

void refuse(httplib::Response& response, Fault fault, const std::string& sentence) {
  answer_fault(response, status_of(fault), error_body(fault, sentence));
}

/// The token in "a=1; tramline_token=T".
std::string token_in_cookies(const std::string& cookies) {
  std::size_t from = 0;
  while (from < cookies.size()) {
    while (from < cookies.size() && cookies[from] == ' ') ++from;
    const std::size_t end = std::min(cookies.find(';', from), cookies.size());
    const std::string cookie = cookies.substr(from, end - from);
    if (cookie.starts_with(kCookie)) return cookie.substr(std::string_view(kCookie).size());
    from = end + 1;
  }
  return "";
}

/// Longer than any; a number followed by anything else is not one.
std::uint64_t length_of(const httplib::Request& request) {
  const std::string text = request.get_header_value("Content-Length");
  if (text.empty()) return 0;
  if (text.size() > 18 || text.find_first_not_of("0123456789") != std::string::npos) return UINT64_MAX;
  return std::stoull(text);
}

}  // namespace

bool is_loopback(const std::string& host) {
  return host == "localhost" || host == "::1" || (host.starts_with("127.") && is_numeric(host));
}

bool same_secret(const std::string& a, const std::string& b) {
  unsigned different = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < a.size(); ++i)
    different |= static_cast<unsigned>(a[i] ^ (b.empty() ? 'x' : b[i % b.size()]));
  return different == 0;
}

Gate::Gate(const std::string& host, int port, std::string token) : port_(port), token_(std::move(token)) {
  for (const std::string& name :
       {std::string("127.0.0.1"), std::string("localhost"), std::string("::1"), host})
    hosts_.insert(with_port(name, port));
  any_address_ = host == "0.0.0.0" || host == "::";
  if (any_address_)
    for (const std::string& name : {own_name(), own_name() + ".local"}) hosts_.insert(with_port(name, port));
}

bool Gate::knows_host(const std::string& host) const {
  const std::string own = io::lower_case(host);
  if (hosts_.contains(own) || (port_ == 80 && hosts_.contains(own + ":80"))) return true;
  const std::string port = fmt::format(":{}", port_);
  return any_address_ && own.ends_with(port) && is_numeric(own.substr(0, own.size() - port.size()));
}

bool Gate::has_token(const httplib::Request& request) const {
  const std::string authorization = request.get_header_value("Authorization");
  if (authorization.starts_with("Bearer ")) return same_secret(authorization.substr(7), token_);
  return same_secret(token_in_cookies(request.get_header_value("Cookie")), token_);
}

bool Gate::lets_in(const httplib::Request& request, httplib::Response& response,
                   std::size_t most_bytes) const {
  const std::string host = request.get_header_value("Host");
  if (request.get_header_value_count("Host") != 1 || !knows_host(host)) {
    refuse(
        response, Fault::kForbidden,
        "this server is not known under that name; open it by the address that was printed when it started");
    return false;
  }
  if (request.has_header("Origin") &&
      io::lower_case(request.get_header_value("Origin")) != "http://" + io::lower_case(host)) {
    refuse(response, Fault::kForbidden, "another page may not use this server; open its own page");
    return false;
  }
  // The token is handed in there; whoever reads from there has it already.
  const bool hands_in = request.method == "POST" && request.path == api("/session");
  const bool is_api = request.path.starts_with(kApi) && !hands_in;
  if (!token_.empty() && is_api && !has_token(request)) {
    refuse(response, Fault::kForbidden,
           "this server asks for a token; open the address that was printed when it started, with all that "
           "stands "
           "behind its #");
    return false;
  }
  if (length_of(request) > most_bytes && most_bytes > 0) {
    refuse(response, Fault::kTooLarge,
           fmt::format("this is more than the {} MB that are taken here; send less", most_bytes >> 20));
    return false;
  }
  return true;
}

}  // namespace tramline::server
