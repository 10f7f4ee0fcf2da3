#pragma once
// A histogram of one figure over many fields.

#include <filesystem>
#include <string>
#include <vector>

namespace tramline::render {

struct Histogram {
  std::string title, subtitle;
  std::string of;              ///< what is counted along the axis, with its unit: "euros per hectare"
  std::vector<double> values;  ///< finite and not negative
};

/// Bars of equal width from 0, on a round step; the last one holds all that lies beyond the 99th
/// percentile. The file is written whole or not at all. Throws bad_input for a name that does not end in
/// .png, .svg or .pdf, and Error(kFailure). O(n log n).
void draw_histogram(const Histogram& histogram, const std::filesystem::path& path);

}  // namespace tramline::render
