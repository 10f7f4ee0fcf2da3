// Any text as a table of fixes.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "sound_log.h"
#include "tramline/geometry/error.h"
#include "tramline/io/log/csv_log.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    tramline::io::TextLines lines(text);
    tramline::fuzz::demand_sound(tramline::io::read_csv_log(lines, "", "", "'fuzz'"));
  } catch (const tramline::Error&) {
    // A refusal is an answer; any other exception is a fault.
  }
  return 0;
}
