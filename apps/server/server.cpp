#include "server/server.h"

#include <fmt/format.h>
#include <sys/socket.h>

#include <atomic>
#include <utility>

#include "server/http/gate.h"
#include "server/http/http_error.h"
#include "server/http/own_addresses.h"
#include "server/routes/routes.h"
#include "tramline/geometry/error.h"
#include "tramline/io/vector/foreign_files.h"

namespace tramline::server {
namespace {

/// Threads beside those that open streams hold.
constexpr int kWorkers = 8;

/// More than this is not piled up for somebody who reads slowly: a frame of a stream is made when there is
/// room for it, so that it says what is, and not what was long ago. Connections have it from the port.
constexpr int kMostUnsentBytes = 1 << 14;

/// Connections that may wait to be taken. Debian's cpp-httplib has room for five, fewer than a browser opens
/// at once: on a busy machine the others were cut off.
constexpr int kMostWaiting = 128;

/// Two servers on one port would take turns, so the port is not shared.
void own_the_port(socket_t socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  setsockopt(socket, IPPROTO_TCP, TCP_NOTSENT_LOWAT, &kMostUnsentBytes, sizeof(kMostUnsentBytes));
}

}  // namespace

void add_routes(Router& router, App& app) {
  add_about_routes(router, app);
  add_session_routes(router, app);
  add_upload_routes(router, app);
  add_field_routes(router, app);
  add_machine_routes(router, app);
  add_job_routes(router, app);
  add_plan_routes(router, app);
  add_drive_routes(router, app);
  add_feed_routes(router, app);
  add_plan_file_routes(router, app);
  add_front_routes(router, app);
  add_page_routes(router, app);
}

struct Server::Parts {
  explicit Parts(ServerSettings settings) : app(std::move(settings)) {}
  App app;
  Router router;
  httplib::Server http;
  int port = 0;
  socket_t listening = INVALID_SOCKET;
  std::atomic<bool> stopping = false;
};

Server::Server(ServerSettings settings) : parts_(std::make_unique<Parts>(std::move(settings))) {
  io::open_plain_files_only();
  if (parts_->app.settings.token.empty() && !is_loopback(parts_->app.settings.host))
    throw bad_input(
        fmt::format("others can reach {} too, so a token has to be asked for; give one with --token",
                    parts_->app.settings.host));
  App& app = parts_->app;
  const Router& router = parts_->router;
  httplib::Server& http = parts_->http;
  add_routes(parts_->router, app);
  http.new_task_queue = [&app] {
    return new httplib::ThreadPool(static_cast<std::size_t>(app.settings.limits.streams + kWorkers));
  };
  // A connection that waits for its next request would hold a thread; a new one costs next to nothing here.
  http.set_keep_alive_max_count(1);
  http.set_tcp_nodelay(true);
  http.set_socket_options([this](socket_t socket) {
    own_the_port(socket);
    parts_->listening = socket;
  });
  http.set_read_timeout(30);
  http.set_write_timeout(30);

  const ServerSettings& given = app.settings;
  const bool bound = given.port == 0 ? (parts_->port = http.bind_to_any_port(given.host)) > 0
                                     : http.bind_to_port(given.host, parts_->port = given.port);
  if (!bound)
    throw bad_input(
        fmt::format("port {} on {} cannot be had: another program, perhaps another tramline, uses it, or "
                    "it is not allowed; choose another with --port, or end that one",
                    given.port, given.host));

  listen(parts_->listening, kMostWaiting);

  const Gate gate(given.host, parts_->port, given.token);
  http.set_pre_routing_handler([gate, &router](const httplib::Request& request, httplib::Response& response) {
    const bool has_body = request.method == "POST" || request.method == "PUT" || request.method == "PATCH";
    if (!gate.lets_in(request, response, router.most_bytes(request)))
      return httplib::Server::HandlerResponse::Handled;
    if (has_body) return httplib::Server::HandlerResponse::Unhandled;
    router.serve(request, response, nullptr);
    return httplib::Server::HandlerResponse::Handled;
  });
  const auto with_body = [&router](const httplib::Request& request, httplib::Response& response,
                                   const httplib::ContentReader& reader) {
    router.serve(request, response, &reader);
  };
  http.Post("[^]*", with_body);
  http.Put("[^]*", with_body);
  http.Patch("[^]*", with_body);
  http.set_expect_100_continue_handler(
      [gate, &router](const httplib::Request& request, httplib::Response& response) {
        return gate.lets_in(request, response, router.most_bytes(request)) ? 100 : response.status;
      });
  const httplib::Server::HandlerWithResponse in_json = [](const httplib::Request&,
                                                          httplib::Response& response) {
    if (response.body.empty())
      answer_fault(response, response.status,
                   error_body(Fault::kBadInput, "the request is none that a server understands"));
    return httplib::Server::HandlerResponse::Handled;
  };
  http.set_error_handler(in_json);
}

Server::~Server() { stop(); }

int Server::port() const { return parts_->port; }

std::vector<std::string> Server::addresses() const {
  const ServerSettings& given = parts_->app.settings;
  std::vector<std::string> out;
  for (const std::string& host : own_addresses(given.host)) {
    const bool six = host.find(':') != std::string::npos;
    out.push_back(fmt::format("http://{}{}{}:{}/{}", six ? "[" : "", host, six ? "]" : "", parts_->port,
                              given.token.empty() ? "" : "#token=" + given.token));
  }
  return out;
}

const std::vector<std::string>& Server::warnings() const { return parts_->app.warnings; }

void Server::run() {
  if (!parts_->stopping) parts_->http.listen_after_bind();
  parts_->app.jobs.stop();
}

void Server::stop() {
  parts_->stopping = true;
  parts_->app.streams.stop();
  parts_->http.stop();
}

}  // namespace tramline::server
