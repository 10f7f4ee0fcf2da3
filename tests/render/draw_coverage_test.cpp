#include "tramline/render/coverage/draw_coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "io/coverage/two_passes.h"
#include "sample_plan.h"
#include "tramline/geometry/error.h"
#include "tramline/model/palette.h"

namespace tramline::render {
namespace {

ErrorKind kind_thrown(const Coverage& coverage, const std::filesystem::path& path,
                      const PictureOptions& options = {}) {
  try {
    draw_coverage(coverage, path, options);
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.kind();
  }
  ADD_FAILURE() << "nothing was thrown";
  return ErrorKind::kFailure;
}

/// The pixels of a picture of 1600 px, asked for by places of the field.
class Map {
 public:
  Map(const Folder& folder, const Coverage& coverage) : view_(layout_of(coverage).view) {
    draw_coverage(coverage, folder / "map.png");
    pixels_ = std::make_unique<Pixels>(folder / "map.png");
  }
  std::uint32_t at(Point p) const { return pixels_->at(view_.to_page(p)); }
  /// Whether a pixel within `radius_px` of the place has the colour.
  bool has_near(Point p, std::uint32_t colour, int radius_px) const {
    const Point middle = view_.to_page(p);
    for (int dx = -radius_px; dx <= radius_px; ++dx)
      for (int dy = -radius_px; dy <= radius_px; ++dy)
        if (pixels_->at({middle.x + dx, middle.y + dy}) == colour) return true;
    return false;
  }
  double px_per_m() const { return view_.px_per_m; }

 private:
  MapView view_;
  std::unique_ptr<Pixels> pixels_;
};

/// Blue less red of the bluest pixel at or beside the place; -22 on covered land.
int bluest_near(const Map& map, Point p) {
  int out = -255;
  for (const double shift : {-1.0, 0.0, 1.0}) {
    const std::uint32_t colour = map.at(p + Point{shift / map.px_per_m(), 0});
    out = std::max(out, static_cast<int>(colour & 0xff) - static_cast<int>(colour >> 16));
  }
  return out;
}

bool is_dark(std::uint32_t colour) {
  return ((colour >> 16) & 0xff) < 0x90 && ((colour >> 8) & 0xff) < 0x90 && (colour & 0xff) < 0x90;
}

TEST(DrawCoverage, LandHasItsColoursWhereItLies) {
  const Folder folder;
  const Map map(folder, two_passes());
  for (const double y : {3.0, 21.0, 37.0}) {
    EXPECT_EQ(map.at({5, y}), kCoveredHex);
    EXPECT_EQ(map.at({13, y}), kCoveredHex);
    EXPECT_EQ(map.at({18, y}), kOverlapHex);
    EXPECT_EQ(map.at({30, y}), kCoveredHex);
    EXPECT_EQ(map.at({36.5, y}), kUncoveredHex);
    EXPECT_EQ(map.at({40.5, y}), kBackgroundHex);
    EXPECT_EQ(map.at({-0.5, y}), kBackgroundHex);
  }
  EXPECT_EQ(map.at({34, 42.5}), kCoveredOutsideHex);
  EXPECT_EQ(map.at({10, 42.5}), kBackgroundHex);
  EXPECT_EQ(map.at({38, 42.5}), kBackgroundHex);
}

TEST(DrawCoverage, ThePathIsSolidWhereItWorkedAndDashedWhereNot) {
  const Folder folder;
  const Coverage coverage = two_passes();
  const Map map(folder, coverage);
  // Away from the middles of pixels, a thin line may share its colour between two.
  const auto share_of_ink = [&](Point from, Point to, std::uint32_t ground) {
    int ink = 0;
    constexpr int kSteps = 400;
    for (int i = 0; i < kSteps; ++i) {
      const Point p = from + (i / static_cast<double>(kSteps)) * (to - from);
      const Point beside{1 / map.px_per_m(), 0};
      ink += map.at(p) != ground || map.at(p + beside) != ground || map.at(p - beside) != ground;
    }
    return ink / static_cast<double>(kSteps);
  };
  EXPECT_EQ(share_of_ink({10, 2}, {10, 38}, kCoveredHex), 1);
  const double dashed = share_of_ink({10.5, 40.75}, {14, 46}, kBackgroundHex);
  EXPECT_GT(dashed, 0.4);
  EXPECT_LT(dashed, 0.95);
}

TEST(DrawCoverage, AGapWithRoomIsNumberedInside) {
  const Folder folder;
  const Coverage coverage = two_passes();
  const Map map(folder, coverage);
  ASSERT_GT(4 * map.px_per_m(), 40);
  // The badge is a white disc; just beyond it the gap's own colour goes on.
  EXPECT_EQ(map.at({38 - 8 / map.px_per_m(), 20}), kBackgroundHex);
  EXPECT_EQ(map.at({38, 20 + 16 / map.px_per_m()}), kUncoveredHex);
}

TEST(DrawCoverage, AGapThinnerThanAPixelIsSeenAndNumbered) {
  const Folder folder;
  Coverage coverage = two_passes();
  coverage.missed = {{box_ring(30, 5, 30.01, 15), {}}};
  coverage.gaps = {{1, coverage.missed[0], 0.1, {30.005, 10}, 0.01}};
  const Map map(folder, coverage);
  // Up to half of its least width may fall on the neighbouring pixel.
  EXPECT_GT(bluest_near(map, {30.005, 6}), 60);
  // A dark dot on the gap, and the badge's rim at the end of its leader.
  EXPECT_TRUE(is_dark(map.at({30.005, 10})));
  const Point up_right{30.005 + 30 * std::sqrt(0.5) / map.px_per_m(),
                       10 + 30 * std::sqrt(0.5) / map.px_per_m()};
  EXPECT_TRUE(map.has_near(up_right, kBackgroundHex, 9));
}

TEST(DrawCoverage, WithoutAFieldAllCoveredLandIsShown) {
  const Folder folder;
  Coverage coverage = two_passes();
  coverage.field.clear();
  coverage.missed.clear();
  coverage.gaps.clear();
  coverage.field_id.clear();
  coverage.areas = {1700, 1540, 0, 1540, 160, 0, 0, 0, {0, 1380, 160, 0}};
  const Box drawn = drawn_box(coverage);
  EXPECT_EQ(drawn.max_x, 36);
  EXPECT_EQ(drawn.max_y, 45);
  const Map map(folder, coverage);
  EXPECT_EQ(map.at({34, 42.5}), kCoveredHex);
  EXPECT_EQ(map.at({18, 21}), kOverlapHex);
  EXPECT_EQ(map.at({38, 21}), kBackgroundHex);
}

TEST(DrawCoverage, WorkFarFromTheFieldDoesNotShrinkIt) {
  Coverage coverage = two_passes();
  coverage.width_m = 3;
  coverage.covered.push_back({box_ring(5000, 5000, 5100, 5100), {}});
  const Box drawn = drawn_box(coverage);
  EXPECT_LE(drawn.max_x, 46);
  EXPECT_GE(drawn.max_y, 45);
  EXPECT_LE(drawn.max_y, 46);
}

TEST(DrawCoverage, NothingIsDrawnOutsideTheMap) {
  const Folder folder;
  Coverage coverage = two_passes();
  const Coverage near = coverage;
  // A drive to the farm and back, across title and legend.
  coverage.lines.push_back({-1, {{26, 0}, {3000, 900}, {-3000, 1800}}, 154, 900});
  draw_coverage(near, folder / "near.png");
  draw_coverage(coverage, folder / "far.png");
  const Pixels a(folder / "near.png"), b(folder / "far.png");
  const PageLayout page = layout_of(coverage);
  ASSERT_EQ(a.width(), b.width());
  ASSERT_EQ(a.height(), b.height());
  int apart = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const Point p{x + 0.5, y + 0.5};
      if (a.at(p) == b.at(p)) continue;
      ++apart;
      ASSERT_TRUE(x >= page.map.min_x - 1 && x <= page.map.max_x && y >= page.map.min_y - 1 &&
                  y <= page.map.max_y)
          << x << " " << y;
    }
  EXPECT_GT(apart, 0);
}

TEST(DrawCoverage, AnObstacleIsTheGroundUnderTheWork) {
  const Folder folder;
  Coverage coverage = two_passes();
  coverage.missed.clear();
  coverage.gaps.clear();
  coverage.field[0].holes = {reversed(box_ring(36.5, 5, 39.5, 9)), reversed(box_ring(3, 5, 7, 9))};
  const Map map(folder, coverage);
  EXPECT_LT(map.at({38, 7}) & 0xff, 0x90u);
  EXPECT_EQ(map.at({5, 7}), kCoveredOutsideHex);
}

TEST(DrawCoverage, SameEvaluationGivesTheSameBytes) {
  const Folder folder;
  for (const std::string extension : {".png", ".svg", ".pdf"}) {
    draw_coverage(two_passes(), folder / ("a" + extension));
    draw_coverage(two_passes(), folder / ("b" + extension));
    const std::string bytes = bytes_of(folder / ("a" + extension));
    EXPECT_GT(bytes.size(), 1000u) << extension;
    EXPECT_EQ(bytes, bytes_of(folder / ("b" + extension))) << extension;
  }
}

/// A straight drive of 100,000 fixes has two places that matter.
TEST(DrawCoverage, LongDrivesMakeNoLongPictures) {
  const Folder folder;
  Coverage coverage = two_passes();
  draw_coverage(coverage, folder / "short.svg");
  std::vector<Point>& line = coverage.lines[0].line;
  line.clear();
  for (int i = 0; i <= 100'000; ++i) line.push_back({10, 40 * i / 100'000.0});
  draw_coverage(coverage, folder / "long.svg");
  EXPECT_LT(bytes_of(folder / "long.svg").size(), bytes_of(folder / "short.svg").size() + 1000);
}

TEST(DrawCoverage, OtherExtensionIsBadInput) {
  const Folder folder;
  for (const std::string name : {"coverage.jpg", "coverage", "png"})
    EXPECT_EQ(kind_thrown(two_passes(), folder / name), ErrorKind::kBadInput);
  EXPECT_EQ(kind_thrown(two_passes(), folder / "coverage.png", {10}), ErrorKind::kBadInput);
  EXPECT_EQ(folder.entries(), 0);
}

TEST(DrawCoverage, RefusesWhatHasNothingToDraw) {
  const Folder folder;
  EXPECT_EQ(kind_thrown(Coverage{}, folder / "coverage.png"), ErrorKind::kBadInput);
  Coverage coverage = two_passes();
  coverage.field[0].outer[2].x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(kind_thrown(coverage, folder / "coverage.png"), ErrorKind::kBadInput);
  EXPECT_EQ(kind_thrown(two_passes(), folder / "missing/coverage.png"), ErrorKind::kFailure);
  EXPECT_EQ(folder.entries(), 0);
}

TEST(DrawCoverage, APlainFrameAndAFieldWithoutWorkAreDrawn) {
  const Folder folder;
  Coverage coverage = two_passes();
  coverage.frame = {false, 0, 0, 500000, 5800000};
  EXPECT_EQ(Map(folder, coverage).at({18, 21}), kOverlapHex);
  Coverage idle;
  idle.field = two_passes().field;
  idle.missed = idle.field;
  idle.areas.missed_m2 = 1600;
  EXPECT_EQ(Map(folder, idle).at({18, 21}), kUncoveredHex);
}

}  // namespace
}  // namespace tramline::render
