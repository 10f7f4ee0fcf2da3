#pragma once
// Upright pages of A4, at the half point per pixel of PDF pages.

namespace tramline::render {

inline constexpr int kA4Width_px = 1190, kA4Height_px = 1684;
inline constexpr double kA4Margin = 70;

}  // namespace tramline::render
