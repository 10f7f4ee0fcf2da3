#pragma once
// A server on this machine, with a folder of its own, and a client of it.

#include <gtest/gtest.h>
#include <httplib.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "server/server.h"
#include "support/temporary_folder.h"

namespace tramline::server::testing_server {

using nlohmann::ordered_json;

struct Reply {
  int status = 0;
  std::string body;
  httplib::Headers headers;
  ordered_json json;  ///< discarded where the body is none

  /// Of an error.
  std::string code() const { return text("code"); }
  std::string message() const { return text("message"); }

 private:
  std::string text(const char* key) const {
    return json.is_object() && json.contains("error") ? json["error"].value(key, "") : "";
  }
};

class ServerHere {
 public:
  explicit ServerHere(const std::filesystem::path& folder) {
    ServerSettings settings;
    settings.folder = folder;
    server_ = std::make_unique<Server>(settings);
    running_ = std::thread([this] { server_->run(); });
    for (int i = 0; i < 500 && get("/").status != 200; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ServerHere(const ServerHere&) = delete;
  ServerHere& operator=(const ServerHere&) = delete;
  ~ServerHere() {
    server_->stop();
    running_.join();
  }

  Reply get(const std::string& path) const { return reply(client()->Get(api_of(path).c_str())); }
  Reply remove(const std::string& path) const { return reply(client()->Delete(api_of(path).c_str())); }
  Reply post(const std::string& path, const std::string& body) const {
    return reply(client()->Post(api_of(path).c_str(), body, "application/json"));
  }
  Reply post(const std::string& path, const ordered_json& json) const { return post(path, json.dump()); }
  Reply upload(const std::string& name, const std::string& bytes) const {
    return reply(client()->Post(("/api/v1/uploads?name=" + name).c_str(), bytes, "application/octet-stream"));
  }

  /// Waits for the job of an answer; 60 s at most.
  ordered_json job_of(const Reply& begun) const {
    if (begun.status != 202) {
      ADD_FAILURE() << begun.status << " " << begun.body;
      return {{"state", "refused"}};
    }
    const std::string path = "/jobs/" + begun.json.at("id").get<std::string>();
    ordered_json job;
    for (int i = 0; i < 3000; ++i) {
      job = get(path).json;
      const std::string state = job.at("state");
      if (state != "queued" && state != "running") return job;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    ADD_FAILURE() << "the job does not end: " << job.dump();
    return job;
  }

  using OnEvent = std::function<bool(const std::string& name, const ordered_json& data)>;
  /// Events of a stream until it ends, or `on_event` says false. The status of the answer.
  int follow(const std::string& path, const OnEvent& on_event) const {
    std::string rest;
    int status = 0;
    const auto connection = client();
    connection->Get(
        api_of(path).c_str(),
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

 private:
  std::unique_ptr<httplib::Client> client() const {
    auto out = std::make_unique<httplib::Client>("127.0.0.1", server_->port());
    out->set_read_timeout(60);
    return out;
  }
  static std::string api_of(const std::string& path) { return "/api/v1" + path; }
  static Reply reply(const httplib::Result& result) {
    Reply out;
    if (!result) return out;
    out.status = result->status;
    out.body = result->body;
    out.headers = result->headers;
    out.json = ordered_json::parse(out.body, nullptr, false);
    return out;
  }

  std::unique_ptr<Server> server_;
  std::thread running_;
};

}  // namespace tramline::server::testing_server
