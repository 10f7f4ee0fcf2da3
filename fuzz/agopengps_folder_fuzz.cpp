// Any text as the files of an AgOpenGPS field folder, of which lines of three dashes are the borders.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "memory_file.h"
#include "sound_log.h"
#include "tramline/geometry/error.h"
#include "tramline/io/agopengps/field_folder.h"
#include "tramline/io/agopengps/sections_log.h"

namespace {

using tramline::fuzz::demand;
using tramline::io::FieldFolder;

constexpr std::array kFiles = {"Field.txt", "Boundary.txt", "TrackLines.txt", "Headlines.txt",
                               "Sections.txt"};

void write_files(const tramline::fuzz::MemoryFolder& folder, std::string_view text) {
  constexpr std::string_view kBorder = "\n---\n";
  for (const char* const file : kFiles) {
    const std::size_t border = text.find(kBorder);
    folder.write(file, text.substr(0, border));
    text.remove_prefix(border == std::string_view::npos ? text.size() : border + kBorder.size());
  }
}

void demand_finite(const std::vector<tramline::Point>& points) {
  for (const tramline::Point p : points) demand(std::isfinite(p.x) && std::isfinite(p.y));
}

void demand_sound_field(const tramline::RawDataset& dataset) {
  for (const tramline::RawFeature& feature : dataset.layers.at(0).features) {
    demand(!feature.polygons.empty());
    for (const tramline::RawPolygon& polygon : feature.polygons)
      for (const tramline::RawRing& ring : polygon.rings) {
        demand(ring.points.size() >= 3);
        demand_finite(ring.points);
      }
  }
}

void demand_sound_guides(const tramline::RawDataset& dataset) {
  for (const tramline::RawFeature& feature : dataset.layers.at(0).features)
    for (const auto& line : feature.lines) {
      demand(line.size() >= 2);
      demand_finite(line);
    }
}

/// A refusal is an answer; any other exception is a fault.
template <class Read>
void read_or_refuse(const Read& read) {
  try {
    read();
  } catch (const tramline::Error&) {
    return;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const tramline::fuzz::MemoryFolder folder;
  write_files(folder, {reinterpret_cast<const char*>(data), size});
  read_or_refuse([&] {
    const auto fields = FieldFolder::open(folder.at("").string());
    demand(fields.has_value());
    read_or_refuse([&] { demand_sound_field(field_in(*fields)); });
    read_or_refuse([&] { demand_sound_guides(guides_in(*fields)); });
    read_or_refuse([&] { tramline::fuzz::demand_sound(sections_log(*fields)); });
  });
  return 0;
}
