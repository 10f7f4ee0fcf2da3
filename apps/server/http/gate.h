#pragma once
// Access control for requests.

#include <httplib.h>

#include <cstddef>
#include <set>
#include <string>

namespace tramline::server {

/// Whether a server on this host is reachable only from this computer.
bool is_loopback(const std::string& host);

/// Refuses requests that other pages in the same browser send: those addressed to a foreign name that
/// resolves to this computer (Host), and those with a foreign origin (Origin). Where there is a token, it
/// also refuses requests without it. The page itself is served without the token: it contains no data, and
/// asks for it.
class Gate {
 public:
  Gate(const std::string& host, int port, std::string token);

  /// False with an answer where the request is refused; its body has not been read then. `most_bytes`: the
  /// longest body its route takes.
  bool lets_in(const httplib::Request& request, httplib::Response& response, std::size_t most_bytes) const;

 private:
  bool knows_host(const std::string& host) const;
  bool has_token(const httplib::Request& request) const;

  std::set<std::string> hosts_;  ///< with the port
  bool any_address_ = false;     ///< all of this computer's addresses are served
  int port_;
  std::string token_;
};

/// Compares in a time that does not depend on the number of equal characters.
bool same_secret(const std::string& a, const std::string& b);

}  // namespace tramline::server
