#pragma once
// Line cards: a page to print for each field of plan files.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace tramline::app {

struct LineCardReport {
  std::size_t cards = 0;
  std::size_t lines = 0;
};

/// Writes a PDF of a page for each field: the AB line of each subfield, its ends and heading, and the order
/// in which tracks are driven. `field`: key or id of the only one wanted; empty: all. Throws bad_input for
/// fields in plain metres, which have no place on earth.
LineCardReport write_line_cards(const std::vector<std::filesystem::path>& plans, const std::string& field,
                                double tolerance_m, const std::filesystem::path& file);

}  // namespace tramline::app
