#pragma once

#include <string_view>

namespace tramline::server {

/// apps/server/openapi.json: the description of the API.
std::string_view openapi();

}  // namespace tramline::server
