// A sound plan file of which bytes are replaced: the page of the file, the place in it and the new bytes,
// again and again. What cannot be read is refused.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <ios>
#include <iterator>
#include <string>

#include "memory_file.h"
#include "support/small_plan.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/write_plan.h"

namespace {

using namespace tramline;

const fuzz::MemoryFolder& folder() {
  static const fuzz::MemoryFolder out;
  return out;
}

std::string sound_file() {
  io::write_plan(testing_support::small_plan(), folder().at("sound.gpkg"));
  std::ifstream file(folder().at("sound.gpkg"), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string sound = sound_file();
  std::string bytes = sound;
  // Each change: three bytes for the place, one for how many bytes follow, up to 15.
  for (std::size_t i = 0; i + 4 < size;) {
    const std::size_t place = (data[i] << 16 | data[i + 1] << 8 | data[i + 2]) % bytes.size();
    std::size_t count = data[i + 3] % 16;
    for (i += 4; count > 0 && i < size; --count, ++i)
      if (const std::size_t at = place + count; at < bytes.size()) bytes[at] = static_cast<char>(data[i]);
  }
  try {
    const io::PlanFile read = io::read_plan_file(folder().write("plan.gpkg", bytes));
    if (read.track_order.size() != read.plan.pieces.size()) std::abort();
  } catch (const tramline::Error&) {
    // A refusal is an answer; any other exception is a fault.
  }
  return 0;
}
