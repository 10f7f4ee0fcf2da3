#pragma once
// A tractor that sends its lines over TCP.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <stdexcept>
#include <string>

namespace tramline::server::testing_drives {

/// Listens on a free port of this machine. One connection at a time.
class FakeTractor {
 public:
  FakeTractor() : FakeTractor(0) {}
  explicit FakeTractor(int port) {
    listening_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int on = 1;
    setsockopt(listening_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<in_port_t>(port));
    socklen_t size = sizeof address;
    auto* any = reinterpret_cast<sockaddr*>(&address);
    if (bind(listening_, any, size) != 0 || listen(listening_, 4) != 0 ||
        getsockname(listening_, any, &size) != 0)
      throw std::runtime_error("the fake tractor has no port");
    port_ = ntohs(address.sin_port);
  }
  FakeTractor(const FakeTractor&) = delete;
  FakeTractor& operator=(const FakeTractor&) = delete;
  ~FakeTractor() {
    hang_up();
    close(listening_);
  }

  int port() const { return port_; }
  std::string address() const { return "tcp://127.0.0.1:" + std::to_string(port_); }

  /// Waits for somebody to connect, 10 s at most.
  void answer() {
    pollfd wanted{listening_, POLLIN, 0};
    if (poll(&wanted, 1, 10000) != 1) throw std::runtime_error("nobody calls the fake tractor");
    line_ = accept(listening_, nullptr, nullptr);
  }
  void send(const std::string& text) {
    for (std::size_t sent = 0; sent < text.size();) {
      const ssize_t some = ::send(line_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
      if (some <= 0) throw std::runtime_error("the fake tractor is cut off");
      sent += static_cast<std::size_t>(some);
    }
  }
  void hang_up() {
    if (line_ >= 0) close(line_);
    line_ = -1;
  }

 private:
  int listening_ = -1, line_ = -1, port_ = 0;
};

}  // namespace tramline::server::testing_drives
