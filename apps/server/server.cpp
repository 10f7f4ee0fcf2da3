#include "server/server.h"

#include <fmt/format.h>
#include <sys/socket.h>

#include <atomic>
#include <utility>

#include "server/http/gate.h"
#include "server/http/http_error.h"
#include "server/http/own_addresses.h"
#include "server/http/threads_on_demand.h"
#include "server/routes/routes.h"
#include "tramline/geometry/error.h"
#include "tramline/io/vector/foreign_files.h"

namespace tramline::server {
namespace {

/// Connections that are served at once, beside open streams: each has a thread of its own.
constexpr int kMostConnections = 128;
/// A client that is silent for so long is given up.
constexpr int kSilence_s = 10;

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

void require_token_where_others_come(const ServerSettings& given) {
  if (given.token.empty() && !is_loopback(given.host))
    throw bad_input(fmt::format(
        "other computers can reach {}, so browsers need a token; give one with --token", given.host));
}

void set_up_connections(httplib::Server& http, int threads) {
  http.new_task_queue = [threads] { return new ThreadsOnDemand(static_cast<std::size_t>(threads)); };
  // A connection that waits for its next request would hold a thread; a new one costs next to nothing here.
  http.set_keep_alive_max_count(1);
  http.set_tcp_nodelay(true);
  http.set_read_timeout(kSilence_s);
  http.set_write_timeout(30);
}

int bound_port(httplib::Server& http, const ServerSettings& given) {
  const int any = given.port == 0 ? http.bind_to_any_port(given.host) : -1;
  if (any > 0) return any;
  if (given.port != 0 && http.bind_to_port(given.host, given.port)) return given.port;
  throw bad_input(
      fmt::format("port {} on {} cannot be opened: another program, perhaps another tramline, uses it, or it "
                  "is not allowed; choose another port with --port, or end that program",
                  given.port, given.host));
}

/// Each of many ranges would be a part of the answer, with a head of its own and perhaps the whole file in
/// it. A server may ignore a Range header (RFC 9110, 14.2): then the answer is the whole, with status 200.
void answer_one_range_at_most(const httplib::Request& request) {
  // The library hands its own request to handlers as one that does not change, and reads the ranges from it
  // afterwards.
  if (request.ranges.size() > 1) const_cast<httplib::Request&>(request).ranges.clear();
}

/// Every request goes through the gate, and then to its route. The router is kept by reference.
void set_handlers(httplib::Server& http, const Gate& gate, const Router& router) {
  http.set_pre_routing_handler([gate, &router](const httplib::Request& request, httplib::Response& response) {
    answer_one_range_at_most(request);
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
                   error_body(Fault::kBadInput, "the request is not one that a server understands"));
    return httplib::Server::HandlerResponse::Handled;
  };
  http.set_error_handler(in_json);
}

}  // namespace

void add_routes(Router& router, App& app) {
  add_about_routes(router, app);
  add_background_routes(router, app);
  add_session_routes(router, app);
  add_upload_routes(router, app);
  add_field_routes(router, app);
  add_machine_routes(router, app);
  add_turn_routes(router);
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
  const ServerSettings& given = parts_->app.settings;
  if (!given.background.empty())
    parts_->app.background = std::make_unique<io::BackgroundMap>(given.background);
  require_token_where_others_come(given);
  add_routes(parts_->router, parts_->app);
  set_up_connections(parts_->http, given.limits.streams + kMostConnections);
  parts_->http.set_socket_options([this](socket_t socket) {
    own_the_port(socket);
    parts_->listening = socket;
  });
  parts_->port = bound_port(parts_->http, given);
  parts_->app.addresses = addresses();
  listen(parts_->listening, kMostWaiting);
  set_handlers(parts_->http, Gate(given.host, parts_->port, given.token), parts_->router);
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
