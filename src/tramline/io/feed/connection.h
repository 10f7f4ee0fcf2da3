#pragma once
// A TCP connection that is reopened when it is lost.

#include <netinet/in.h>
#include <sys/socket.h>

#include <chrono>
#include <string>
#include <vector>

#include "tramline/io/feed/descriptor.h"

namespace tramline::io {

/// "host:port", "[::1]:2947" or, where a port is known already, "host". Throws bad_input, naming `option`.
struct HostPort {
  std::string host, port;
};
HostPort host_and_port(const std::string& text, const std::string& option, const std::string& default_port);

/// A connection that never blocks after construction.
class Connection {
 public:
  /// Connects, waiting 10 s at most. Throws bad_input, beginning with `what`, where nobody answers.
  Connection(const HostPort& place, std::string what);

  /// The descriptor; -1 while there is no connection, or one is being opened.
  int descriptor() const { return connected_ ? socket_.number() : -1; }
  /// The time until try_again() is due, ms.
  int wait_ms() const;
  /// Closes a lost connection.
  void drop();
  /// Tries to connect again; true when it is connected.
  bool try_again();
  ReadResult read(std::string& bytes, int& fault) { return read_some(socket_, bytes, fault); }
  void send(const std::string& text);

 private:
  struct Address {
    sockaddr_storage storage{};
    socklen_t length = 0;
  };
  bool begin();
  int pending_fault(int timeout_ms);

  std::vector<Address> addresses_;  ///< looked up once, because name resolution blocks
  std::size_t next_ = 0;
  Descriptor socket_;
  bool connected_ = false;
  std::chrono::steady_clock::time_point begun_;
};

}  // namespace tramline::io
