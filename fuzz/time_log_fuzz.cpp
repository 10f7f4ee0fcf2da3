// Any bytes as the records of an ISOXML time log: of one with sections, of one with all parts of positions,
// or of one with two devices, row units without widths and counters.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sound_log.h"
#include "tramline/geometry/error.h"
#include "tramline/io/isoxml/time_log.h"

namespace {

const std::string kSections =
    R"(<TIM A=""><PTN A="" B="" D=""/><DLV A="008D" B="" C="DET-1"/><DLV A="0043" B="" C="DET-2"/>)"
    R"(<DLV A="00A1" B="" C="DET-1"/><DLV A="0087" B="" C="DET-3"/></TIM>)";
const std::string kAllParts =
    R"(<TIM A=""><PTN A="" B="" C="" D="" E="" F="" G="" H="" I=""/><DLV A="0043" B="" C="DET-1"/></TIM>)";
const std::string kDevices =
    R"(<TIM A=""><PTN A="" B="" D=""/><DLV A="0043" B="" C="DET-5"/><DLV A="00A1" B="" C="DET-5"/>)"
    R"(<DLV A="0087" B="" C="DET-6"/><DLV A="0086" B="" C="DET-7"/><DLV A="008D" B="" C="DET-8"/>)"
    R"(<DLV A="0043" B="" C="DET-8"/><DLV A="0074" B="" C="DET-8"/><DLV A="0077" B="" C="DET-5"/>)"
    R"(<DLV A="0075" B="" C="DET-9"/><DLV A="008D" B="" C="DET-9"/></TIM>)";

std::vector<tramline::io::DeviceElement> elements() {
  return {{"DET-5", "DVC-2", 2, 1, 0, 1, {{70, 6000}}},
          {"DET-6", "DVC-2", 5, 2, 1, 2, {}},
          {"DET-7", "DVC-2", 5, 3, 1, 3, {{134, -500}, {135, 700}}},
          {"DET-8", "DVC-3", 1, 1, 0, 1, {}},
          {"DET-9", "DVC-4", 1, 1, 0, 1, {}},
          {"DET-1", "DVC-1", 1, 0, 0, 1, {}},
          {"DET-2", "DVC-1", 4, 1, 1, 2, {{67, 3000}, {135, -1500}}},
          {"DET-3", "DVC-1", 4, 2, 1, 3, {{67, 3000}, {135, 1500}}}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (bytes.empty()) return 0;
  // The first byte chooses the header.
  const std::string& header = bytes[0] % 3 == 0 ? kSections : bytes[0] % 3 == 1 ? kAllParts : kDevices;
  try {
    tramline::fuzz::demand_sound(
        tramline::io::decode_time_log(header, bytes.substr(1), elements(), "'fuzz'"));
  } catch (const tramline::Error&) {
    // A refusal is an answer; any other exception is a fault.
  }
  return 0;
}
