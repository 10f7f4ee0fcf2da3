#pragma once
// A plan small enough to know by heart, and ways to look into pictures.

#include <cairo.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>

#include "support/box_ring.h"
#include "support/temporary_folder.h"
#include "tramline/model/plan.h"

namespace tramline::render {

using testing_support::box;

/// 100 m × 60 m, w = 10 m, one obstacle [40, 50] × [20, 30]; tracks run north; overlap is
/// [60, 64] × [0, 60], uncovered [90, 96] × [0, 60].
inline Plan sample_plan() {
  Plan plan;
  plan.field.id = "sample";
  plan.field.outer = box(0, 0, 100, 60);
  Ring hole = box(40, 20, 50, 30);
  plan.field.obstacles.push_back({{hole, {}}, ObstacleKind::kObstacle, "hole 1"});
  plan.machine.width_m = 10;
  plan.body = {{plan.field.outer, {reversed(hole)}}};
  plan.subfields.push_back({plan.body[0], Direction::clockwise_from_north(Angle::degrees(0))});
  for (int track = 0; track < 9; ++track) {
    const double x = 5 + 10 * track;
    if (track == 4) {
      plan.pieces.push_back({{x, 0}, {x, 20}, 0, track, false, true});
      plan.pieces.push_back({{x, 60}, {x, 30}, 0, track, false, true});
    } else if (track % 2 == 0) {
      plan.pieces.push_back({{x, 0}, {x, 60}, 0, track});
    } else {
      plan.pieces.push_back({{x, 60}, {x, 0}, 0, track});
    }
  }
  plan.overlap = {{box(60, 0, 64, 60), {}}};
  plan.uncovered = {{box(90, 0, 96, 60), {}}};
  plan.tally = {5300, 240, 360, 530, 10, 0, 9, 2};
  plan.cost = 59.65;
  return plan;
}

/// A PNG as 0xRRGGBB pixels.
class Pixels {
 public:
  explicit Pixels(const std::filesystem::path& png)
      : surface_(cairo_image_surface_create_from_png(png.c_str())) {
    if (cairo_surface_status(surface_.get()) != CAIRO_STATUS_SUCCESS) throw std::runtime_error("no PNG");
  }
  int width() const { return cairo_image_surface_get_width(surface_.get()); }
  int height() const { return cairo_image_surface_get_height(surface_.get()); }
  std::uint32_t at(Point p) const {
    const unsigned char* row = cairo_image_surface_get_data(surface_.get()) +
                               static_cast<int>(p.y) * cairo_image_surface_get_stride(surface_.get());
    return reinterpret_cast<const std::uint32_t*>(row)[static_cast<int>(p.x)] & 0xFFFFFF;
  }

 private:
  struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
};

using Folder = testing_support::TemporaryFolder;

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace tramline::render
