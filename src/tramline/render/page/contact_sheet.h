#pragma once
// Many pictures on one page.

#include <filesystem>
#include <string>
#include <vector>

namespace tramline::render {

/// Puts PNGs side by side, row by row, each scaled to one column's width with its caption below, and
/// writes the sheet (PNG, SVG or PDF by extension) whole or not at all.
/// Throws bad_input for a file that is not a readable PNG, for an empty list of files, for a number of
/// captions other than that of files, and for fewer columns than one.
void contact_sheet(const std::vector<std::filesystem::path>& pngs, const std::vector<std::string>& captions,
                   const std::filesystem::path& out, int columns);

}  // namespace tramline::render
