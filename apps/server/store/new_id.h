#pragma once

#include <string>
#include <string_view>

namespace tramline::server {

/// An id that nothing has had before: date and time in UTC to the microsecond, and some letters by chance:
/// "20260314-081500-k3f90a1b2c". Ids are in the order in which they were given, also within a second. What
/// follows does not depend on what a user has typed.
std::string new_id();

/// [a-z0-9-]{1,64}
bool is_id(std::string_view text);

/// A secret token: 32 letters from the system's random source.
std::string new_token();

/// "2026-03-14T08:15:00Z"
std::string time_now();

}  // namespace tramline::server
