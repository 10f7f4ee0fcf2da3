#include "tramline/io/geopackage/time_stamp.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <string_view>

#include "tramline/geometry/error.h"

namespace tramline::io {

std::time_t time_of_files() {
  const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
  if (epoch == nullptr || *epoch == '\0') return 0;
  long long seconds = 0;
  const std::string_view digits(epoch);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), seconds);
  constexpr long long kYear9999 = 253402300799;
  if (error != std::errc{} || end != digits.data() + digits.size() || seconds < 0 || seconds > kYear9999)
    throw bad_input(
        fmt::format("SOURCE_DATE_EPOCH is '{}'; give whole seconds since 1970 or unset it", epoch));
  return static_cast<std::time_t>(seconds);
}

std::string time_stamp() { return fmt::format("{:%Y-%m-%dT%H:%M:%S}.000Z", fmt::gmtime(time_of_files())); }

}  // namespace tramline::io
