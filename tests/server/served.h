#pragma once
// A server in this process, with a folder of its own, and a client that speaks JSON.

#include <gtest/gtest.h>
#include <httplib.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <utility>

#include "server/server.h"
#include "support/temporary_folder.h"

namespace tramline::server {

using nlohmann::ordered_json;

/// Status and body of an answer.
struct Got {
  int status = 0;
  ordered_json json;
  std::string text;
  httplib::Headers headers;

  /// The sentence of an error; empty where it is none.
  std::string message() const { return of_error("message"); }
  std::string code() const { return of_error("code"); }

 private:
  std::string of_error(const char* key) const {
    return json.is_object() && json.contains("error") ? json["error"].value(key, "") : "";
  }
};

class Served {
 public:
  explicit Served(const std::filesystem::path& folder, ServerSettings settings = {}) {
    settings.folder = folder;
    server_ = std::make_unique<Server>(std::move(settings));
    thread_ = std::thread([this] { server_->run(); });
    for (int i = 0; i < 500 && get("/").status == 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  Served(const Served&) = delete;
  Served& operator=(const Served&) = delete;
  ~Served() {
    server_->stop();
    thread_.join();
  }

  int port() const { return server_->port(); }
  const Server& server() const { return *server_; }

  Got get(const std::string& path) const {
    return call([&](httplib::Client& client) { return client.Get(whole(path), headers); });
  }
  Got post(const std::string& path, const ordered_json& body) const { return post_text(path, body.dump()); }
  Got post_text(const std::string& path, const std::string& body) const {
    return call([&](httplib::Client& client) { return client.Post(whole(path), headers, body, kJson); });
  }
  Got put(const std::string& path, const ordered_json& body) const {
    return call(
        [&](httplib::Client& client) { return client.Put(whole(path), headers, body.dump(), kJson); });
  }
  Got patch(const std::string& path, const ordered_json& body) const { return patch_text(path, body.dump()); }
  Got patch_text(const std::string& path, const std::string& body) const {
    return call([&](httplib::Client& client) { return client.Patch(whole(path), headers, body, kJson); });
  }
  Got remove(const std::string& path) const {
    return call([&](httplib::Client& client) { return client.Delete(whole(path), headers); });
  }
  Got upload(const std::string& name, const std::string& bytes) const {
    return call([&](httplib::Client& client) {
      return client.Post("/api/v1/uploads?name=" + name, headers, bytes, "application/octet-stream");
    });
  }
  Got upload_example(const std::string& name) const {
    return upload(name, testing_support::bytes_of(std::filesystem::path(EXAMPLES) / name));
  }
  /// The id of the first feature of an example, kept as a field.
  std::string field_of(const std::string& example) const {
    const Got sent = upload_example(example);
    EXPECT_EQ(sent.status, 201) << sent.text;
    const Got kept = post("/fields", {{"upload", sent.json["id"]}, {"fid", sent.json["features"][0]["fid"]}});
    EXPECT_EQ(kept.status, 201) << kept.text;
    return kept.json.value("id", "");
  }
  /// The job when it is over.
  ordered_json finished(const ordered_json& job) const {
    const std::string path = "/jobs/" + job.value("id", "");
    for (int i = 0; i < 6000; ++i) {
      const Got now = get(path);
      const std::string state = now.json.value("state", "");
      if (state != "queued" && state != "running") return now.json;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return {};
  }
  /// The job that an answer is about, when it is over.
  ordered_json job_of(const Got& begun) const {
    if (begun.status == 202) return finished(begun.json);
    ADD_FAILURE() << begun.status << " " << begun.text;
    return {{"state", "refused"}};
  }
  /// The id of a plan for the field.
  std::string planned(const std::string& field, const ordered_json& settings = ordered_json::object(),
                      bool explain = false) const {
    const Got begun = post("/jobs", {{"kind", "plan"},
                                     {"field", field},
                                     {"machine", {{"name", "drill"}, {"width_m", 12}, {"radius_m", 6}}},
                                     {"settings", settings},
                                     {"explain", explain}});
    const ordered_json job = job_of(begun);
    EXPECT_EQ(job.value("state", ""), "done") << job.dump();
    return job["result"].is_object() ? job["result"].value("plan", "") : "";
  }

  using OnEvent = std::function<bool(const std::string& name, const ordered_json& data)>;
  /// Events of a stream until it ends, or `on_event` says false. The status of the answer.
  int follow(const std::string& path, const OnEvent& on_event) const {
    std::string rest;
    int status = 0;
    httplib::Client client("127.0.0.1", port());
    client.set_read_timeout(60);
    client.Get(
        whole(path), headers,
        [&](const httplib::Response& response) {
          status = response.status;
          return true;
        },
        [&](const char* data, std::size_t size) {
          rest.append(data, size);
          for (std::size_t end = rest.find("\n\n"); end != std::string::npos; end = rest.find("\n\n")) {
            const std::string block = rest.substr(0, end);
            rest.erase(0, end + 2);
            const std::size_t data_at = block.find("\ndata: ");
            if (!block.starts_with("event: ") || data_at == std::string::npos) continue;
            if (!on_event(block.substr(7, data_at - 7), ordered_json::parse(block.substr(data_at + 7))))
              return false;
          }
          return true;
        });
    return status;
  }

  /// Bytes as they are to a socket; everything that comes back.
  std::string raw(const std::string& bytes) const {
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port()));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
    // The server may have answered and gone before all was sent.
    for (std::size_t sent = 0; sent < bytes.size();) {
      const ssize_t now = send(socket, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (now <= 0) break;
      sent += static_cast<std::size_t>(now);
    }
    std::string out(1 << 16, '\0');
    std::size_t got = 0;
    for (ssize_t now = 0; (now = recv(socket, out.data() + got, out.size() - got, 0)) > 0;)
      got += static_cast<std::size_t>(now);
    close(socket);
    return out.substr(0, got);
  }
  std::string own_host() const { return "127.0.0.1:" + std::to_string(port()); }

  httplib::Headers headers;  ///< sent with every request

 private:
  static constexpr const char* kJson = "application/json";
  static std::string whole(const std::string& path) { return "/api/v1" + path; }

  template <class Function>
  Got call(Function&& function) const {
    httplib::Client client("127.0.0.1", port());
    client.set_read_timeout(60);
    const httplib::Result result = function(client);
    Got out;
    if (!result) return out;
    out.status = result->status;
    out.text = result->body;
    out.headers = result->headers;
    out.json = ordered_json::parse(out.text, nullptr, false);
    return out;
  }

  std::unique_ptr<Server> server_;
  std::thread thread_;
};

/// Each test has a server with an empty folder.
class ServerTest : public testing::Test {
 protected:
  testing_support::TemporaryFolder folder;
  Served served{folder.path()};
};

/// A square with a side of 200 m at 50° north, on the globe.
inline ordered_json square(double west = 9, double south = 50) {
  const double east = west + 0.0028, north = south + 0.0018;
  return {{"type", "Polygon"},
          {"coordinates", {{{west, south}, {east, south}, {east, north}, {west, north}, {west, south}}}}};
}

}  // namespace tramline::server
