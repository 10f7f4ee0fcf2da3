#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>

#include "tramline/geometry/error.h"
#include "tramline/io/feed/descriptor.h"
#include "tramline/io/feed/feed.h"
#include "tramline/io/feed/line_splitter.h"

namespace tramline::io {
namespace {

/// Of both internet protocols; of the old one where there is no other.
Descriptor bound_socket(int port, int& fault) {
  const auto number = static_cast<in_port_t>(port);
  Descriptor six(socket(AF_INET6, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (six.open()) {
    const int off = 0;
    setsockopt(six.number(), IPPROTO_IPV6, IPV6_V6ONLY, &off, sizeof off);
    sockaddr_in6 address{};
    address.sin6_family = AF_INET6;
    address.sin6_addr = in6addr_any;
    address.sin6_port = htons(number);
    if (bind(six.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return six;
    fault = errno;
    if (fault == EADDRINUSE || fault == EACCES) return {};
  }
  Descriptor four(socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_ANY);
  address.sin_port = htons(number);
  if (four.open() && bind(four.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
    return four;
  fault = errno;
  return {};
}

class UdpFeed final : public Feed {
 public:
  explicit UdpFeed(int port) : port_(port) {
    int fault = 0;
    socket_ = bound_socket(port, fault);
    if (!socket_.open())
      throw bad_input(fmt::format("--udp {}: the port cannot be opened ({}){}", port, words_for(fault),
                                  fault == EADDRINUSE ? "; does another program listen there?" : ""));
    // Room for what comes while the disk is slow.
    const int bytes = 1 << 22;
    setsockopt(socket_.number(), SOL_SOCKET, SO_RCVBUF, &bytes, sizeof bytes);
  }

  std::string name() const override { return fmt::format("udp:{}", port_); }
  int descriptor() const override { return socket_.number(); }
  int wait_ms() const override { return -1; }

  Received receive() override {
    Received out;
    // A datagram is never longer.
    std::array<char, 1 << 16> buffer;
    for (int i = 0; i < kAtOnce; ++i) {
      const ssize_t got = recv(socket_.number(), buffer.data(), buffer.size(), 0);
      if (got < 0) return out;
      LineSplitter splitter;
      splitter.add({buffer.data(), static_cast<std::size_t>(got)}, out.lines);
      if (splitter.has_rest()) out.lines.push_back(splitter.take_rest());
    }
    out.more = true;
    return out;
  }

 private:
  static constexpr int kAtOnce = 256;
  int port_;
  Descriptor socket_;
};

}  // namespace

std::unique_ptr<Feed> udp_feed(int port) { return std::make_unique<UdpFeed>(port); }

}  // namespace tramline::io
