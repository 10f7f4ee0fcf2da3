#include "tramline/io/feed/connection.h"

#include <fmt/format.h>
#include <netdb.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>

#include "tramline/geometry/error.h"

namespace tramline::io {
namespace {

using std::chrono::milliseconds;

constexpr int kPatience_ms = 10000;

struct FreeAddresses {
  void operator()(addrinfo* list) const { freeaddrinfo(list); }
};

bool is_port(const std::string& text) {
  return !text.empty() && text.size() <= 5 && text.find_first_not_of("0123456789") == std::string::npos &&
         std::stoi(text) >= 1 && std::stoi(text) <= 65535;
}

}  // namespace

HostPort host_and_port(const std::string& text, const std::string& option, const std::string& default_port) {
  HostPort out{text, default_port};
  const std::size_t bracket = text.find(']');
  const std::size_t colon = text.find(':', bracket == std::string::npos ? 0 : bracket);
  const bool plain_v6 = bracket == std::string::npos && colon != text.rfind(':');
  if (colon != std::string::npos && !plain_v6) out = {text.substr(0, colon), text.substr(colon + 1)};
  if (out.host.starts_with('[') && out.host.ends_with(']'))
    out.host = out.host.substr(1, out.host.size() - 2);
  if (out.host.empty() || !is_port(out.port))
    throw bad_input(fmt::format("{} '{}' is no {}, such as {}", option, text,
                                default_port.empty() ? "HOST:PORT" : "HOST or HOST:PORT",
                                default_port.empty() ? "tractor.local:5017" : "localhost:" + default_port));
  return out;
}

Connection::Connection(const HostPort& place, std::string what) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int fault = getaddrinfo(place.host.c_str(), place.port.c_str(), &hints, &found);
  const std::unique_ptr<addrinfo, FreeAddresses> list(found);
  if (fault != 0)
    throw bad_input(fmt::format("{}: there is no host '{}' ({})", what, place.host, gai_strerror(fault)));
  for (const addrinfo* one = list.get(); one != nullptr; one = one->ai_next) {
    Address address;
    std::memcpy(&address.storage, one->ai_addr, one->ai_addrlen);
    address.length = one->ai_addrlen;
    addresses_.push_back(address);
  }
  int last = 0;
  for (std::size_t i = 0; i < addresses_.size() && !connected_; ++i) {
    if (begin()) last = pending_fault(kPatience_ms);
    connected_ = socket_.open() && last == 0;
  }
  if (!connected_)
    throw bad_input(fmt::format("{}: nothing answers at {}:{} ({})", what, place.host, place.port,
                                words_for(last == 0 ? ECONNREFUSED : last)));
}

bool Connection::begin() {
  const Address& address = addresses_[next_];
  next_ = (next_ + 1) % addresses_.size();
  begun_ = std::chrono::steady_clock::now();
  socket_ = Descriptor(socket(address.storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!socket_.open()) return false;
  // A receiver that loses its power says no farewell.
  const int on = 1, idle_s = 10;
  setsockopt(socket_.number(), SOL_SOCKET, SO_KEEPALIVE, &on, sizeof on);
  setsockopt(socket_.number(), IPPROTO_TCP, TCP_KEEPIDLE, &idle_s, sizeof idle_s);
  if (connect(socket_.number(), reinterpret_cast<const sockaddr*>(&address.storage), address.length) == 0 ||
      errno == EINPROGRESS)
    return true;
  socket_.reset();
  return false;
}

/// 0: connected; EINPROGRESS: not yet.
int Connection::pending_fault(int timeout_ms) {
  pollfd wanted{socket_.number(), POLLOUT, 0};
  const int ready = poll(&wanted, 1, timeout_ms);
  if (ready == 0) return timeout_ms > 0 ? ETIMEDOUT : EINPROGRESS;
  int fault = 0;
  socklen_t size = sizeof fault;
  if (ready < 0 || getsockopt(socket_.number(), SOL_SOCKET, SO_ERROR, &fault, &size) != 0) return errno;
  return fault;
}

int Connection::wait_ms() const {
  if (connected_) return -1;
  const auto passed = std::chrono::steady_clock::now() - begun_;
  const auto left = milliseconds(kAgain_ms) - std::chrono::duration_cast<milliseconds>(passed);
  // A connection that is being made is looked at more often.
  return socket_.open() ? 50 : static_cast<int>(std::max<long long>(0, left.count()));
}

void Connection::drop() {
  socket_.reset();
  connected_ = false;
  begun_ = std::chrono::steady_clock::now();
}

bool Connection::try_again() {
  if (connected_) return false;
  const auto passed = std::chrono::steady_clock::now() - begun_;
  if (!socket_.open()) {
    if (passed < milliseconds(kAgain_ms) || !begin()) return false;
  }
  const int fault = pending_fault(0);
  if (fault == EINPROGRESS && passed < milliseconds(kPatience_ms)) return false;
  connected_ = fault == 0;
  if (!connected_) socket_.reset();
  return connected_;
}

void Connection::send(const std::string& text) {
  std::string_view rest = text;
  while (!rest.empty()) {
    const ssize_t sent = ::send(socket_.number(), rest.data(), rest.size(), MSG_NOSIGNAL);
    if (sent <= 0) return;  // the reading side will tell
    rest.remove_prefix(static_cast<std::size_t>(sent));
  }
}

}  // namespace tramline::io
