#pragma once
// The addresses under which others reach this machine.

#include <string>
#include <vector>

namespace tramline::server {

/// Hosts that a browser can open where the server listens on `host`: itself, but for 0.0.0.0 and ::, which
/// mean all that this machine has: version 4 first, those that reach further before 127.0.0.1. Addresses that
/// hold only on one cable (fe80::) are left out.
std::vector<std::string> own_addresses(const std::string& host);

}  // namespace tramline::server
