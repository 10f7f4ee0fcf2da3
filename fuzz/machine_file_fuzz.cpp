// Any bytes as a machine file.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "memory_file.h"
#include "tramline/geometry/error.h"
#include "tramline/io/machine/read_machine.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const tramline::fuzz::MemoryFolder folder;
  const auto path = folder.write("m.toml", {reinterpret_cast<const char*>(data), size});
  try {
    const tramline::Machine machine = tramline::io::read_machine(path);
    const bool sound = machine.width_m > 0 && std::isfinite(machine.width_m) && machine.radius_m >= 0 &&
                       std::isfinite(machine.radius_m);
    if (!sound) std::abort();
  } catch (const tramline::Error&) {
    // A refusal is an answer; any other exception is a fault.
  }
  return 0;
}
