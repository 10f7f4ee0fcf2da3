#include "tramline/render/plan/draw_plan.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "sample_plan.h"
#include "tramline/geometry/error.h"
#include "tramline/model/palette.h"

namespace tramline::render {
namespace {

ErrorKind kind_thrown(const Plan& plan, const std::filesystem::path& path,
                      const PictureOptions& options = {}) {
  try {
    draw_plan(plan, path, options);
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.kind();
  }
  ADD_FAILURE() << "nothing was thrown";
  return ErrorKind::kFailure;
}

TEST(DrawPlan, PngHasTheSizeOfItsLayout) {
  const Folder folder;
  draw_plan(sample_plan(), folder / "plan.png");
  const Pixels pixels(folder / "plan.png");
  EXPECT_EQ(pixels.width(), 1600);
  EXPECT_EQ(pixels.height(), layout_of(sample_plan()).height_px);
  draw_plan(sample_plan(), folder / "small.PNG", {800});
  EXPECT_EQ(Pixels(folder / "small.PNG").width(), 800);
}

TEST(DrawPlan, FaultsHaveTheirColoursWhereTheyLie) {
  const Folder folder;
  const Plan plan = sample_plan();
  draw_plan(plan, folder / "plan.png");
  const Pixels pixels(folder / "plan.png");
  const MapView view = layout_of(plan).view;
  for (const double y : {2.0, 41.0, 58.0}) {
    EXPECT_EQ(pixels.at(view.to_page({62, y})), kOverlapHex);
    EXPECT_EQ(pixels.at(view.to_page({93, y})), kUncoveredHex);
    EXPECT_EQ(pixels.at(view.to_page({-4, y})), kBackgroundHex);
    EXPECT_EQ(pixels.at(view.to_page({103, y})), kBackgroundHex);
  }
}

TEST(DrawPlan, WaysWithoutRoomAreSeenOverMissedLandAndOthersAreNot) {
  const Folder folder;
  Plan plan = sample_plan();
  const Pose east{{85, 30}, Heading::clockwise_from_north(Angle::degrees(90))};
  RouteLeg leg;
  leg.kind = LegKind::kTransit;
  leg.path = {arc_from(east, 14, 0, Gear::kForward)};
  plan.route.legs = {leg};
  const Point on_missed_land = layout_of(plan).view.to_page({93, 30});
  draw_plan(plan, folder / "room.png");
  EXPECT_EQ(Pixels(folder / "room.png").at(on_missed_land), kUncoveredHex);
  plan.route.legs.front().missing_m = 2;
  const Point there = layout_of(plan).view.to_page({93, 30});
  draw_plan(plan, folder / "no-room.png");
  EXPECT_EQ(Pixels(folder / "no-room.png").at(there), kNoRoomHex);
}

TEST(DrawPlan, ObstacleIsDark) {
  const Folder folder;
  const Plan plan = sample_plan();
  draw_plan(plan, folder / "plan.png");
  const Pixels pixels(folder / "plan.png");
  const std::uint32_t colour = pixels.at(layout_of(plan).view.to_page({42, 28}));
  EXPECT_LT(colour & 0xff, 0x90u);
}

TEST(DrawPlan, SliverThinnerThanAPixelIsSeen) {
  const Folder folder;
  Plan plan = sample_plan();
  plan.uncovered = {{box(80, 0, 80.005, 60), {}}};
  draw_plan(plan, folder / "plan.png");
  const Pixels pixels(folder / "plan.png");
  const Point middle = layout_of(plan).view.to_page({80.0025, 47});
  // Up to a third of the sliver's width may fall on the neighbouring pixel.
  int bluest = 0;
  for (const double shift : {-1.0, 0.0, 1.0}) {
    const std::uint32_t colour = pixels.at({middle.x + shift, middle.y});
    bluest = std::max(bluest, static_cast<int>(colour & 0xff) - static_cast<int>(colour >> 16));
  }
  EXPECT_GT(bluest, 100);
}

TEST(DrawPlan, RoundingBetweenSwathsIsNotDrawn) {
  const Folder folder;
  const Plan clean = sample_plan();
  Plan plan = clean;
  plan.uncovered.push_back({box(80, 0, 80 + 2e-6, 60), {}});
  draw_plan(clean, folder / "clean.png");
  draw_plan(plan, folder / "plan.png");
  EXPECT_EQ(bytes_of(folder / "plan.png"), bytes_of(folder / "clean.png"));
}

TEST(DrawPlan, SamePlanGivesTheSameBytes) {
  const Folder folder;
  for (const std::string extension : {".png", ".svg", ".pdf"}) {
    draw_plan(sample_plan(), folder / ("a" + extension));
    draw_plan(sample_plan(), folder / ("b" + extension));
    const std::string bytes = bytes_of(folder / ("a" + extension));
    EXPECT_GT(bytes.size(), 1000u) << extension;
    EXPECT_EQ(bytes, bytes_of(folder / ("b" + extension))) << extension;
  }
}

TEST(DrawPlan, PdfIsDatedBySourceDateEpoch) {
  const Folder folder;
  ::unsetenv("SOURCE_DATE_EPOCH");
  draw_plan(sample_plan(), folder / "a.pdf");
  EXPECT_NE(bytes_of(folder / "a.pdf").find("19700101"), std::string::npos);
  ::setenv("SOURCE_DATE_EPOCH", "86400", 1);
  draw_plan(sample_plan(), folder / "b.pdf");
  EXPECT_NE(bytes_of(folder / "b.pdf").find("19700102"), std::string::npos);
  ::unsetenv("SOURCE_DATE_EPOCH");
}

TEST(DrawPlan, OtherExtensionIsBadInputAndNamesTheThree) {
  const Folder folder;
  for (const std::string name : {"plan.jpg", "plan", "png"}) {
    try {
      draw_plan(sample_plan(), folder / name);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
      for (const char* known : {".png", ".svg", ".pdf"})
        EXPECT_NE(std::string(error.what()).find(known), std::string::npos);
    }
  }
  EXPECT_EQ(folder.entries(), 0);
}

TEST(DrawPlan, WhatCannotBeWrittenLeavesNothingBehind) {
  const Folder folder;
  EXPECT_EQ(kind_thrown(sample_plan(), folder / "missing/plan.png"), ErrorKind::kFailure);
  EXPECT_EQ(folder.entries(), 0);
  // A folder in the picture's place cannot be renamed over: the temporary file has to go again.
  std::filesystem::create_directories(folder / "plan.png/full");
  EXPECT_EQ(kind_thrown(sample_plan(), folder / "plan.png"), ErrorKind::kFailure);
  EXPECT_EQ(folder.entries(), 1);
}

TEST(DrawPlan, ReplacesAnOlderPicture) {
  const Folder folder;
  std::ofstream(folder / "plan.svg") << "old";
  draw_plan(sample_plan(), folder / "plan.svg");
  EXPECT_EQ(bytes_of(folder / "plan.svg").substr(0, 5), "<?xml");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(DrawPlan, DrawsPlansOfAllSizes) {
  const Folder folder;
  for (const double factor : {0.05, 0.2, 1.0, 24.0}) {
    Plan plan = sample_plan();
    plan.field.outer = box(0, 0, 100 * factor, 60 * factor);
    plan.body = {{plan.field.outer, {}}};
    plan.pieces.clear();
    plan.overlap.clear();
    plan.uncovered.clear();
    plan.field.obstacles.clear();
    plan.subfields.clear();
    draw_plan(plan, folder / "plan.png");
    EXPECT_EQ(Pixels(folder / "plan.png").height(), layout_of(plan).height_px);
  }
}

TEST(DrawPlan, SurvivesAnyName) {
  const Folder folder;
  Plan plan = sample_plan();
  plan.field.id = std::string("caf\xC3\xA9 \xff\xC0\x80 \n\0 <&>", 16);
  for (int i = 0; i < 300; ++i) plan.field.id += "ü";
  draw_plan(plan, folder / "plan.svg");
  draw_plan(plan, folder / "plan.png");
}

TEST(DrawPlan, RefusesWhatHasNoOutline) {
  const Folder folder;
  EXPECT_EQ(kind_thrown(Plan{}, folder / "plan.png"), ErrorKind::kBadInput);
  Plan plan = sample_plan();
  plan.field.outer[2].x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(kind_thrown(plan, folder / "plan.png"), ErrorKind::kBadInput);
  EXPECT_EQ(kind_thrown(sample_plan(), folder / "plan.png", {10}), ErrorKind::kBadInput);
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace tramline::render
