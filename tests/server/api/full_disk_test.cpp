// A disk that is full and has room again, a folder that cannot be written, and one that is deleted.

#include <sys/resource.h>

#include <csignal>
#include <filesystem>

#include "server/served.h"
#include "support/refusals.h"

namespace tramline::server {
namespace {

using testing_support::mentions;

/// While it lives no file of this process can be written to: the system refuses as it does for a full disk.
class FullDisk {
 public:
  FullDisk() : before_(std::signal(SIGXFSZ, SIG_IGN)) {
    EXPECT_EQ(getrlimit(RLIMIT_FSIZE, &room_), 0);
    const rlimit none{0, room_.rlim_max};
    EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &none), 0);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &room_);
    std::signal(SIGXFSZ, before_);
  }

 private:
  void (*before_)(int);
  rlimit room_{};
};

ordered_json drill(const char* name) { return {{"name", name}, {"width_m", 6}, {"radius_m", 6}}; }

class FullDisks : public ServerTest {
 protected:
  void SetUp() override {
    field_ = served.field_of("riverside.geojson");
    plan_ = served.planned(field_, quick_);
    machine_ = served.post("/machines", drill("drill")).json.value("id", "");
  }
  /// All that stores something, one after the other; the statuses.
  std::vector<int> statuses() {
    std::vector<int> out;
    const auto add = [&](const Got& got) {
      out.push_back(got.status);
      EXPECT_TRUE(got.status < 400 || !got.message().empty()) << got.text;
    };
    add(served.post("/machines", drill("another")));
    add(served.put("/machines/" + machine_, drill("renamed")));
    add(served.patch("/fields/" + field_, {{"name", "renamed"}}));
    add(served.patch("/plans/" + plan_, {{"name", "renamed"}}));
    add(served.post("/fields", {{"name", "square"}, {"geometry", square()}}));
    add(served.upload_example("riverside.geojson"));
    add(served.get("/plans/" + plan_ + "/files/geojson"));
    return out;
  }

  const ordered_json quick_{{"strategy", "sweep"}, {"route", false}};
  std::string field_, plan_, machine_;
};

const std::vector<int> kFailed(7, 500), kStored = {201, 200, 200, 200, 201, 201, 200};

TEST_F(FullDisks, NothingChangesWhileItIsFullAndAllIsStoredAfterwards) {
  const ordered_json before = served.get("/machines").json;
  {
    const FullDisk full;
    for (int i = 0; i < 3; ++i) EXPECT_EQ(statuses(), kFailed);
    EXPECT_EQ(served.get("/machines").json, before);
    EXPECT_EQ(served.get("/plans/" + plan_).status, 200);
  }
  EXPECT_EQ(statuses(), kStored);
  EXPECT_EQ(served.get("/machines").json.size(), before.size() + 1);
  EXPECT_EQ(served.get("/plans/" + plan_).json["name"], "renamed");
}

TEST_F(FullDisks, APlanThatCannotBeKeptFailsAndTheNextIsKept) {
  const ordered_json order = {
      {"kind", "plan"}, {"field", field_}, {"machine", drill("drill")}, {"settings", quick_}};
  {
    const FullDisk full;
    const ordered_json job = served.job_of(served.post("/jobs", order));
    EXPECT_EQ(job.value("state", ""), "failed") << job.dump();
  }
  const ordered_json job = served.job_of(served.post("/jobs", order));
  EXPECT_EQ(job.value("state", ""), "done") << job.dump();
}

TEST_F(FullDisks, NoPartOfAFileIsLeft) {
  {
    const FullDisk full;
    statuses();
  }
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
    EXPECT_FALSE(entry.path().string().ends_with(".part")) << entry.path();
}

TEST_F(FullDisks, AFolderThatIsGoneIsToldOfAndTakenUpWhenItIsBack) {
  const std::filesystem::path aside = folder.path().string() + "-aside";
  std::filesystem::rename(folder.path(), aside);
  EXPECT_EQ(statuses(), kFailed);
  EXPECT_TRUE(
      mentions(served.post("/fields", {{"name", "square"}, {"geometry", square()}}).message(), "is gone"));
  EXPECT_FALSE(std::filesystem::exists(folder.path())) << "another folder in its place has no lock";
  std::filesystem::rename(aside, folder.path());
  EXPECT_EQ(statuses(), kStored);
}

TEST(ReadOnlyFolder, IsRefusedAtTheStart) {
  const std::string sentence = testing_support::refusal_of([] { StoreFolder("/proc/self"); });
  EXPECT_TRUE(mentions(sentence, "nothing can be written into '/proc/self'")) << sentence;
}

}  // namespace
}  // namespace tramline::server
