#include <algorithm>

#include "tramline/geometry/error.h"
#include "tramline/render/page/picture_file.h"
#include "tramline/render/plan/draw_plan.h"
#include "tramline/render/plan/small_map.h"

namespace tramline::render {

void draw_thumbnail(const Plan& plan, const std::filesystem::path& path, int width_px) {
  constexpr int kLeast_px = 40, kMost_px = 600;
  /// Lines are as thin for their picture as those of a sheet of four maps.
  constexpr double kPlainWidth_px = 400;
  const PictureFormat format = format_of(path);
  if (width_px < kLeast_px || width_px > kMost_px)
    throw bad_input("a thumbnail is from 40 to 600 pixels wide");
  const Box drawn = drawn_box({plan});
  const int height_px = std::max(1, static_cast<int>(small_map_height(drawn, width_px)));
  Canvas canvas(format, width_px, height_px);
  const Box all{0, 0, static_cast<double>(width_px), static_cast<double>(height_px)};
  draw_small_map(canvas, plan, drawn, all, width_px / kPlainWidth_px);
  write_whole(path, canvas.finish());
}

}  // namespace tramline::render
