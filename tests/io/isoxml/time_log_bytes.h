#pragma once
// Time logs written byte by byte, as ISO 11783-10 annex D lays them out.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tramline::testing_logs {

/// Numbers, least byte first.
inline std::string little(std::uint64_t value, int bytes) {
  std::string out;
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i) & 0xff);
  return out;
}
inline std::string little_signed(std::int32_t value) { return little(static_cast<std::uint32_t>(value), 4); }

using Values = std::vector<std::pair<int, std::int32_t>>;

inline std::string values_of(const Values& values) {
  std::string out = little(values.size(), 1);
  for (const auto& [index, value] : values)
    out += little(static_cast<std::uint64_t>(index), 1) + little_signed(value);
  return out;
}

/// A record for headers with <PTN A="" B="" D=""/>.
inline std::string record(std::uint32_t ms, std::uint32_t day, std::int32_t lat, std::int32_t lon, int status,
                          const Values& values = {}) {
  return little(ms, 4) + little(day, 2) + little_signed(lat) + little_signed(lon) +
         little(static_cast<std::uint64_t>(status), 1) + values_of(values);
}

inline std::string header(const std::string& values,
                          const std::string& position = R"(<PTN A="" B="" D=""/>)") {
  return R"(<?xml version="1.0"?><TIM A="" D="4">)" + position + values + "</TIM>";
}

}  // namespace tramline::testing_logs
