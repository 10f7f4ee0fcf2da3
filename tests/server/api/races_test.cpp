// What two clients do to the same thing at the same time: both or one of them, and nothing half.

#include <fmt/format.h>

#include <atomic>
#include <random>
#include <thread>

#include "server/served.h"

namespace tramline::server {
namespace {

using std::chrono::microseconds;

/// Runs both at about the same time.
template <class First, class Second>
void at_once(First&& first, Second&& second, microseconds apart) {
  std::thread other([&] { second(); });
  std::this_thread::sleep_for(apart);
  first();
  other.join();
}

std::ptrdiff_t files_in(const std::filesystem::path& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), {});
}

/// A folder with copies of one plan; their ids.
std::vector<std::string> copies_of_a_plan(const std::filesystem::path& folder, int count) {
  std::string plan;
  {
    const Served served(folder);
    plan = served.planned(served.field_of("plain-metres.gpkg"));
  }
  std::vector<std::string> out;
  for (int i = 0; i < count; ++i) {
    out.push_back(fmt::format("20260314-081500-copy{}", i));
    std::filesystem::copy_file(folder / "plans" / (plan + ".gpkg"),
                               folder / "plans" / (out.back() + ".gpkg"));
  }
  std::filesystem::remove(folder / "plans" / (plan + ".gpkg"));
  return out;
}

TEST_F(ServerTest, AFieldThatIsChangedWhileItIsDeletedStaysDeleted) {
  std::mt19937 chance(5);
  for (int i = 0; i < 30; ++i) {
    const std::string id = served.post("/fields", {{"name", "mill"}, {"geometry", square()}}).json["id"];
    int changed = 0, deleted = 0;
    at_once([&] { deleted = served.remove("/fields/" + id).status; },
            [&] {
              changed = served.patch("/fields/" + id, {{"name", "other"}}).status;
            },
            microseconds(chance() % 6000));
    EXPECT_EQ(deleted, 200);
    EXPECT_TRUE(changed == 200 || changed == 404) << changed;
    EXPECT_EQ(served.get("/fields/" + id).status, 404) << "in round " << i;
  }
  EXPECT_EQ(files_in(folder / "fields"), 0);
}

TEST_F(ServerTest, TwoChangesOfAFieldAreBothMade) {
  const ordered_json pole = {{"kind", "obstacle"},
                             {"geometry", {{"type", "Point"}, {"coordinates", {9.001, 50.001}}}},
                             {"size_m", 4}};
  std::mt19937 chance(6);
  for (int i = 0; i < 20; ++i) {
    const std::string id = served.post("/fields", {{"name", "mill"}, {"geometry", square()}}).json["id"];
    at_once(
        [&] {
          EXPECT_EQ(served.patch("/fields/" + id, {{"name", "other"}}).status, 200);
        },
        [&] {
          const Got got = served.patch("/fields/" + id, {{"add", {pole}}});
          EXPECT_EQ(got.status, 200) << got.text;
        },
        microseconds(chance() % 3000));
    const ordered_json field = served.get("/fields/" + id).json;
    EXPECT_EQ(field["name"], "other") << "in round " << i;
    EXPECT_EQ(field["obstacles"], 1) << "in round " << i;
  }
}

TEST(Races, APlanThatIsRenamedWhileItIsDeletedStaysDeleted) {
  const testing_support::TemporaryFolder folder;
  const std::vector<std::string> plans = copies_of_a_plan(folder.path(), 30);
  const Served served(folder.path());
  std::mt19937 chance(7);
  for (const std::string& id : plans) {
    int renamed = 0;
    at_once([&] { EXPECT_EQ(served.remove("/plans/" + id).status, 200); },
            [&] {
              renamed = served.patch("/plans/" + id, {{"name", "other"}}).status;
            },
            microseconds(chance() % 20000));
    EXPECT_TRUE(renamed == 200 || renamed == 404) << renamed;
    EXPECT_EQ(served.get("/plans/" + id).status, 404);
  }
  EXPECT_EQ(files_in(folder / "plans"), 0);
}

TEST(Races, APlanThatIsTakenAwayWhileItIsDeletedIsWholeOrNotThere) {
  const testing_support::TemporaryFolder folder;
  const std::vector<std::string> plans = copies_of_a_plan(folder.path(), 40);
  const Served served(folder.path());
  std::mt19937 chance(8);
  const std::vector<std::string> parts{"", "/layers/tracks", "/layers", "/files/flatgeobuf", "/files/png"};
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const std::string path = "/plans/" + plans[i];
    std::atomic<bool> gone = false;
    at_once(
        [&] {
          served.remove(path);
          gone = true;
        },
        [&] {
          for (bool last = false; !last;) {
            last = gone;
            const Got got = served.get(path + parts[i % parts.size()]);
            EXPECT_TRUE(got.status == 200 || got.status == 404) << got.status << " " << got.text;
            EXPECT_TRUE(!last || got.status == 404);
          }
        },
        microseconds(chance() % 20000));
  }
}

TEST_F(ServerTest, AFieldThatIsDeletedWhileItIsPlannedLeavesAPlanThatHolds) {
  const std::string field = served.field_of("terrace.kml");
  const Got begun = served.post(
      "/jobs", {{"kind", "plan"}, {"field", field}, {"machine", {{"width_m", 12}, {"radius_m", 6}}}});
  EXPECT_EQ(served.remove("/fields/" + field).status, 200);
  const ordered_json job = served.job_of(begun);
  ASSERT_EQ(job["state"], "done") << job.dump();
  const std::string plan = job["result"]["plan"];
  EXPECT_EQ(served.get("/plans/" + plan).json["field"], field);
  EXPECT_EQ(served.get("/plans/" + plan + "/files/geojson").status, 200);
  const ordered_json checked = served.job_of(served.post("/jobs", {{"kind", "check"}, {"plan", plan}}));
  EXPECT_EQ(checked["state"], "done") << checked.dump();
}

}  // namespace
}  // namespace tramline::server
