// Lines of terminals are the middle of a track, other guides the border of two swaths.

#include <gtest/gtest.h>

#include <optional>

#include "request/plan_request.h"
#include "support/refusals.h"
#include "support/small_plan.h"

namespace tramline::app {
namespace {

class GuideRoles : public testing::Test {
 protected:
  GuideRoles() {
    field_.outer = {{0, 0}, {100, 0}, {100, 60}, {0, 60}};
    field_.id = "field";
    machine_.width_m = 4;
  }
  std::vector<Point> placed(const std::vector<Point>& line, GuideRole role,
                            AbAnchor anchor = AbAnchor::kDefault) {
    PlanSettings settings;
    settings.ab_anchor = anchor;
    return settings_for(settings, GuideLine{"guide", line, true, role}, field_, machine_).guide;
  }
  Field field_;
  Machine machine_;
};

TEST_F(GuideRoles, ATrackIsHalfAWidthFromItsBorder) {
  EXPECT_EQ(placed({{10, 30}, {90, 30}}, GuideRole::kBorder), (std::vector<Point>{{10, 30}, {90, 30}}));
  const std::vector<Point> border = placed({{10, 30}, {90, 30}}, GuideRole::kTrack);
  ASSERT_EQ(border.size(), 2U);
  EXPECT_NEAR(border[0].y, 28, 1e-12) << "on the right";
  EXPECT_NEAR(border[1].y, 28, 1e-12);
}

TEST_F(GuideRoles, ACurveIsMovedAsAWhole) {
  const std::vector<Point> line = {{10, 30}, {50, 30}, {90, 40}};
  const std::vector<Point> border = placed(line, GuideRole::kTrack);
  ASSERT_EQ(border.size(), 3U);
  for (const Point p : border)
    EXPECT_NEAR(std::min(distance_to_segment(p, line[0], line[1]), distance_to_segment(p, line[1], line[2])),
                2, 0.05);
}

TEST_F(GuideRoles, AnEnvelopeTakesTheDirectionOnly) {
  EXPECT_EQ(placed({{10, 30}, {90, 30}}, GuideRole::kTrack, AbAnchor::kEnvelope),
            (std::vector<Point>{{10, 30}, {90, 30}}));
}

}  // namespace
}  // namespace tramline::app
