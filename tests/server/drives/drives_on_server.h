#pragma once
// A server to which drives are brought, the same each time.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "server/served.h"
#include "server/work/drives.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/geodesy/placed_log.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/io/log/read_log.h"

namespace tramline::server {

using namespace testing_drives;

inline ordered_json polygon_json(const Polygon& polygon) {
  const FrameProjection projection(frame_here());
  const auto ring_json = [&](Ring ring) {
    ring.push_back(ring.front());
    ordered_json out = ordered_json::array();
    for (const Point p : ring) {
      const Point at = projection.to_lonlat(p);
      out.push_back({at.x, at.y});
    }
    return out;
  };
  ordered_json rings = ordered_json::array({ring_json(polygon.outer)});
  for (const Ring& hole : polygon.holes) rings.push_back(ring_json(hole));
  return {{"type", "Polygon"}, {"coordinates", rings}};
}

class Drives : public ::testing::Test {
 protected:
  std::string new_field() {
    const Got made =
        here_.post("/fields", {{"name", "mill field"}, {"geometry", polygon_json(field_here().front())}});
    EXPECT_EQ(made.status, 201) << made.text;
    return made.json.at("id");
  }
  std::string upload_log(const std::string& bytes, const std::string& name = "spraying.csv") {
    const Got made = here_.upload(name, bytes);
    EXPECT_EQ(made.status, 201) << made.text;
    EXPECT_EQ(made.json.value("kind", ""), "log") << made.text;
    return made.json.value("id", "");
  }
  ordered_json new_drive(ordered_json request) {
    const ordered_json job = here_.job_of(here_.post("/drives", request));
    EXPECT_EQ(job.at("state"), "done") << job.dump();
    if (job.at("state") != "done") return {};
    return here_.get("/drives/" + job.at("result").at("drive").get<std::string>()).json;
  }
  /// The sentence with which a drive is refused when it is evaluated.
  std::string failure_of(const ordered_json& request) {
    const ordered_json job = here_.job_of(here_.post("/drives", request));
    EXPECT_EQ(job.at("state"), "failed") << job.dump();
    return job.at("error").dump();
  }

  testing_support::TemporaryFolder folder_;
  Served here_{folder_.path()};
};

inline Coverage evaluated_here(const std::filesystem::path& log) {
  return coverage::evaluate(placed(io::read_log(log), frame_here()), field_here(), {}, {});
}

}  // namespace tramline::server
