// Any text as a TASKDATA.XML, and as the header of a time log of its machines.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sound_log.h"
#include "tramline/geometry/error.h"
#include "tramline/io/isoxml/time_log.h"

namespace {

// Four records for <PTN A="" B="" D=""/> with the values 0 to 3.
std::string records() {
  const auto little = [](std::uint32_t value, int bytes) {
    std::string out;
    for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i) & 0xff);
    return out;
  };
  std::string out;
  for (std::uint32_t i = 0; i < 4; ++i) {
    out += little(1000 * i, 4) + little(14611, 2) + little(520000000 + i, 4) + little(100000000, 4) +
           little(4, 1);
    out += little(4, 1);
    for (std::uint32_t value = 0; value < 4; ++value) out += little(value, 1) + little(value * 1000 + i, 4);
  }
  return out;
}

void demand_sound(const tramline::RawDataset& fields) {
  for (const tramline::RawLayer& layer : fields.layers)
    for (const tramline::RawFeature& feature : layer.features) {
      tramline::fuzz::demand(!feature.polygons.empty());
      for (const tramline::RawPolygon& polygon : feature.polygons)
        for (const tramline::RawRing& ring : polygon.rings) {
          tramline::fuzz::demand(ring.points.size() >= 3);
          for (const tramline::Point p : ring.points)
            tramline::fuzz::demand(std::abs(p.x) <= 180 && std::abs(p.y) <= 90);
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  // What stands before a line of three dashes is the task data, what stands behind it the header.
  const std::size_t split = text.find("\n---\n");
  const std::string_view header = split == std::string_view::npos ? text : text.substr(split + 5);
  std::vector<tramline::io::DeviceElement> elements;
  try {
    const tramline::io::TaskData tasks = tramline::io::parse_task_data(
        text.substr(0, split), [](const std::string&) { return std::optional<std::string>("<XFC/>"); },
        "fuzz");
    demand_sound(tasks.partfields);
    elements = tasks.elements;
  } catch (const tramline::Error&) {
    // A refusal is an answer; any other exception is a fault.
  }
  try {
    tramline::fuzz::demand_sound(tramline::io::decode_time_log(header, records(), elements, "'fuzz'"));
  } catch (const tramline::Error&) {
    // The same.
  }
  return 0;
}
