// What a header requires of callers is asserted where it can be looked at for less than the work itself
// costs: builds without NDEBUG (dev, debug and the sanitizers) stop at a caller that is wrong.

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <string>

#include "architecture/source_tree.h"

namespace tramline::architecture::preconditions_test {

/// Headers none of whose preconditions are asserted, each with the reason.
const std::map<std::string, std::string> kNotAsserted = {
    {"apps/server/store/drive_store.h", "a look at the disc"},
    {"apps/server/store/store_folder.h", "is thrown in every build"},
    {"src/tramline/check/file/compare_layers.h", "the plan would have to be verified again"},
    {"src/tramline/check/file/compare_warnings.h", "the plan would have to be verified again"},
    {"src/tramline/cost/grid/grid_tally.h", "two shapes in two frames would have to be compared"},
    {"src/tramline/cost/worked/worked_bands.h", "bands are asserted where they are made"},
    {"src/tramline/coverage/dose/laid_cells.h", "where a grid is from cannot be told"},
    {"src/tramline/coverage/drive/interrupted.h", "rounding decides whether a narrow quad is convex"},
    {"include/tramline/coverage/evaluate.h", "steps made by hand leave the label of their frame out"},
    {"src/tramline/coverage/drive/shape_drive.h", "steps made by hand leave the label of their frame out"},
    {"src/tramline/coverage/drive/worked_drive.h", "steps made by hand leave the label of their frame out"},
    {"src/tramline/coverage/mesh/mesh_boolean.h", "an overlay"},
    {"src/tramline/coverage/mesh/mesh_region.h", "holds when all rows are done"},
    {"src/tramline/geometry/offset/offset_rings.h", "crossings of all rings"},
    {"src/tramline/headland/closed_path.h", "rounding decides where the radius is just that of an arc"},
    {"src/tramline/io/gdal/start_gdal.h", "a state of the whole program"},
    {"include/tramline/model/headland.h", "an overlay"},
    {"src/tramline/planner/repair/driven_directions.h", "gaps have area by their making"},
    {"src/tramline/route/order/best_tour.h", "places along tracks would have to be found again"},
    {"src/tramline/route/order/tours.h", "places along tracks would have to be found again"},
    {"src/tramline/planner/curved/zhou_plan.h", "require_zhou_ground() throws in every build"},
    {"src/tramline/planner/assembly/worked_layers.h", "the plan would have to be verified"},
    {"src/tramline/tracks/curved_tracks.h", "regions are indexed: their rings are gone"},
};

bool says(const std::string& text, const char* pattern) {
  return std::regex_search(text, std::regex(pattern));
}

TEST(Preconditions, AreAssertedOrOnTheList) {
  std::set<std::string> excused;
  int stated = 0;
  for (const std::string& path : repository_files()) {
    if (!is_product_source(path) || !path.ends_with(".h")) continue;
    const std::string header = read(path);
    if (!says(header, "Preconditions?\\b")) continue;
    ++stated;
    std::string source = path.substr(0, path.size() - 2) + ".cpp";
    if (source.starts_with("include/")) source.replace(0, std::string("include").size(), "src");
    const std::string code = header + (std::filesystem::exists(source_root() / source) ? read(source) : "");
    const bool asserted = says(code, "\\bassert\\(");
    if (kNotAsserted.contains(path)) excused.insert(path);
    EXPECT_NE(asserted, kNotAsserted.contains(path))
        << path
        << (asserted ? " has assertions now: take it off the list"
                     : " states a precondition, and its source has no assertion");
  }
  EXPECT_GT(stated, 60) << "the headers were not found";
  EXPECT_EQ(excused.size(), kNotAsserted.size()) << "the list names a header that states no precondition";
}

}  // namespace tramline::architecture::preconditions_test
