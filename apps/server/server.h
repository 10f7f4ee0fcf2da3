#pragma once
// The server: the API, and the page that uses it.

#include <memory>
#include <string>
#include <vector>

#include "server/app.h"
#include "server/http/router.h"

namespace tramline::server {

/// Adds all routes, in the order of the API's description.
void add_routes(Router& router, App& app);

class Server {
 public:
  /// Opens the folder and the port. Throws bad_input where either cannot be had, and where another host than
  /// this computer is to be served without a token.
  explicit Server(ServerSettings settings);
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server();

  int port() const;
  /// "http://127.0.0.1:8750/", with the token behind # where there is one. Several where the server listens
  /// on all addresses of this machine: the first is for others, the last for this machine.
  std::vector<std::string> addresses() const;
  /// About files in the folder that could not be read.
  const std::vector<std::string>& warnings() const;

  /// Serves until stop(); returns when all requests have been answered and all jobs have ended.
  void run();
  /// From any thread, also before run(). Open streams end, jobs are cancelled.
  void stop();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace tramline::server
