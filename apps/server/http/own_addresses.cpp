#include "server/http/own_addresses.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <algorithm>
#include <array>
#include <memory>

namespace tramline::server {
namespace {

bool leads_here(const ifaddrs& entry, int family) {
  constexpr unsigned kWanted = IFF_UP | IFF_RUNNING;
  return entry.ifa_addr != nullptr && entry.ifa_addr->sa_family == family &&
         (entry.ifa_flags & kWanted) == kWanted && (entry.ifa_flags & IFF_LOOPBACK) == 0;
}

std::string in_numbers(const sockaddr& address) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  if (address.sa_family == AF_INET) {
    const auto& four = reinterpret_cast<const sockaddr_in&>(address);
    inet_ntop(AF_INET, &four.sin_addr, text.data(), text.size());
    return text.data();
  }
  const auto& six = reinterpret_cast<const sockaddr_in6&>(address);
  if (!IN6_IS_ADDR_LINKLOCAL(&six.sin6_addr)) inet_ntop(AF_INET6, &six.sin6_addr, text.data(), text.size());
  return text.data();
}

/// Of the interfaces that are up, in the system's order.
std::vector<std::string> of_interfaces(int family) {
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) return {};
  const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> list(first, &freeifaddrs);
  std::vector<std::string> out;
  for (const ifaddrs* entry = first; entry != nullptr; entry = entry->ifa_next) {
    if (!leads_here(*entry, family)) continue;
    const std::string address = in_numbers(*entry->ifa_addr);
    if (!address.empty() && std::find(out.begin(), out.end(), address) == out.end()) out.push_back(address);
  }
  return out;
}

}  // namespace

std::vector<std::string> own_addresses(const std::string& host) {
  const bool six = host == "::";
  if (host != "0.0.0.0" && !six) return {host};
  // What listens on :: is reached by version 4, too.
  std::vector<std::string> out = of_interfaces(AF_INET);
  if (six)
    for (std::string& address : of_interfaces(AF_INET6)) out.push_back(std::move(address));
  out.emplace_back("127.0.0.1");
  return out;
}

}  // namespace tramline::server
