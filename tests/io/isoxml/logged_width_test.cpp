// How wide the machines of time logs are: device trees drawn for the purpose.

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "io/isoxml/time_log_bytes.h"
#include "support/refusals.h"
#include "tramline/io/isoxml/device_tree.h"
#include "tramline/io/isoxml/time_log.h"

namespace tramline::io::logged_width_test {

using testing_logs::header;
using testing_logs::record;
using testing_logs::Values;
using testing_support::mentions;

constexpr std::uint32_t kDay = 14611;
constexpr std::int32_t kLat = 545822941, kLon = 102119904;
constexpr unsigned kWidth = 67, kAlong = 134, kAcross = 135;

using Properties = std::map<unsigned, long long>;

/// A device drawn element by element: object ids count from 1, in the order they are added.
class Device {
 public:
  explicit Device(std::string id = "DVC-1") : id_(std::move(id)) {}

  /// Returns the object id.
  long long add(const std::string& id, unsigned type, long long parent, const Properties& properties = {}) {
    const auto object = static_cast<long long>(elements_.size()) + 1;
    elements_.push_back({id, id_, type, object, parent, object, properties});
    return object;
  }
  const std::vector<DeviceElement>& elements() const { return elements_; }

 private:
  std::string id_;
  std::vector<DeviceElement> elements_;
};

const std::string kState = header(R"(<DLV A="008D" B="" C="DET-1"/>)");

WorkLog decoded(const std::string& xml, const std::vector<DeviceElement>& elements,
                const std::vector<Values>& values = {{{0, 1}}}) {
  std::string bytes;
  std::uint32_t ms = 1000;
  for (const Values& one : values) bytes += record(ms += 1000, kDay, kLat, kLon, 4, one);
  return decode_time_log(xml, bytes, elements, "'t.zip', TLG00001");
}

/// The boom of the last record of a machine that logs nothing but its work state.
Boom boom_of(const Device& device) {
  const WorkLog log = decoded(kState, device.elements());
  EXPECT_EQ(log.fixes.back().work, WorkState::kOn);
  return log.fixes.back().boom < 0 ? Boom{} : log.booms[static_cast<std::size_t>(log.fixes.back().boom)];
}

// Disks of 10 m and behind them a crumbler of 10 m till 10 m of land.
TEST(LoggedWidth, ToolsBehindOneAnotherAreAsWideAsOne) {
  Device functions;
  functions.add("DET-1", 1, 0);
  functions.add("DET-2", 2, 1, {{kWidth, 10000}, {kAlong, -2000}, {kAcross, 0}});
  functions.add("DET-3", 2, 1, {{kWidth, 10000}, {kAlong, -4000}, {kAcross, 0}});
  EXPECT_EQ(boom_of(functions), (Boom{{5, -5}}));

  Device sections;
  sections.add("DET-1", 1, 0);
  sections.add("DET-2", 4, 1, {{kWidth, 10000}, {kAlong, -2000}, {kAcross, 0}});
  sections.add("DET-3", 4, 1, {{kWidth, 10000}, {kAlong, -4000}, {kAcross, 0}});
  EXPECT_EQ(boom_of(sections), (Boom{{5, -5}}));

  // Nothing is said along the machine, but the machine is 10 m wide.
  Device whole;
  whole.add("DET-1", 1, 0, {{70, 10000}});
  whole.add("DET-2", 4, 1, {{kWidth, 10000}});
  whole.add("DET-3", 4, 1, {{kWidth, 10000}});
  EXPECT_EQ(boom_of(whole), (Boom{{5, -5}}));
}

// A front mower of 3 m and two at the sides, from 1.35 to 4.55 m: 9.1 m in all.
TEST(LoggedWidth, IntervalsThatOverlapCountOnce) {
  Device mowers;
  mowers.add("DET-1", 1, 0);
  mowers.add("DET-2", 2, 1, {{kWidth, 3000}, {kAlong, 2500}, {kAcross, 0}});
  mowers.add("DET-3", 2, 1, {{kWidth, 3200}, {kAlong, -2500}, {kAcross, -2950}});
  mowers.add("DET-4", 2, 1, {{kWidth, 3200}, {kAlong, -2500}, {kAcross, 2950}});
  const Boom boom = boom_of(mowers);
  ASSERT_EQ(boom.size(), 1U);
  EXPECT_NEAR(boom[0].left_m, 4.55, 1e-12);
  EXPECT_NEAR(boom[0].right_m, -4.55, 1e-12);
}

Device planter(long long width_mm, bool with_offsets, long long apart_mm, unsigned row_type = 5) {
  Device out;
  out.add("DET-1", 1, 0);
  out.add("DET-2", 2, 1);
  for (int row = 0; row < 32; ++row) {
    Properties properties{{kWidth, width_mm}};
    if (with_offsets) properties[kAcross] = apart_mm * (2 * row - 31) / 2;
    out.add("DET-" + std::to_string(10 + row), row_type, 2, properties);
  }
  return out;
}

void expect_width(const Boom& boom, double width_m) {
  ASSERT_EQ(boom.size(), 1U);
  EXPECT_NEAR(boom[0].left_m, width_m / 2, 1e-9);
  EXPECT_NEAR(boom[0].right_m, -width_m / 2, 1e-9);
}

TEST(LoggedWidth, RowsOfAPlanterAreOneWidth) {
  expect_width(boom_of(planter(762, true, 762)), 32 * 0.762);
  expect_width(boom_of(planter(381, false, 0)), 32 * 0.381);
  expect_width(boom_of(planter(762, false, 0, 4)), 32 * 0.762);
  // A row of 0.2 m works up to half way to the next, 0.762 m away.
  expect_width(boom_of(planter(200, true, 762)), 32 * 0.762);
}

TEST(LoggedWidth, RowsLeftOutStayGaps) {
  Device rows;
  rows.add("DET-1", 1, 0);
  // Tramlines are left out: rows at -1.5, -1, 0, 1 and 1.5 m.
  for (const long long across : {-1500, -1000, 0, 1000, 1500})
    rows.add("DET-R" + std::to_string(across), 5, 1, {{kWidth, 300}, {kAcross, across}});
  // The usual distance is 1 m (of 0.5, 1, 1 and 0.5): all meet.
  EXPECT_EQ(boom_of(rows), (Boom{{2, -2}}));
  rows.add("DET-L", 5, 1, {{kWidth, 300}, {kAcross, -4000}});
  EXPECT_EQ(boom_of(rows), (Boom{{4.5, 3.5}, {2, -2}}));
}

TEST(LoggedWidth, SectionsOfABoomInAFunction) {
  Device sprayer;
  sprayer.add("DET-1", 1, 0);
  sprayer.add("DET-2", 2, 1, {{70, 24000}});
  sprayer.add("DET-T", 3, 1, {{kWidth, 2000}, {kAcross, 9000}});  // the tank
  sprayer.add("DET-C", 6, 1, {{kAlong, 3000}});                   // the hitch
  for (const int i : {0, 1, 2, 3, 4})
    sprayer.add(
        "DET-S" + std::to_string(i), 4, 2,
        {{kWidth, i == 2 ? 4000 : 5000}, {kAcross, i == 2 ? 0 : (i - 2) * 5000 - (i < 2 ? -500 : 500)}});
  EXPECT_EQ(boom_of(sprayer), (Boom{{12, -12}}));

  // Sections 1, 2 and 4 spray.
  const std::string xml = header(R"(<DLV A="008D" B="" C="DET-1"/><DLV A="00A1" B="" C="DET-2"/>)");
  const WorkLog log = decoded(xml, sprayer.elements(), {{{0, 1}, {1, 0x45}}, {{0, 0}}});
  EXPECT_EQ(log.booms.at(static_cast<std::size_t>(log.fixes[0].boom)),
            (Boom{{12, 7}, {7, 2}, {2, -2}, {-2, -7}, {-7, -12}}));
  EXPECT_EQ(log.fixes[0].sections, SectionStates("01011"));
  EXPECT_EQ(log.fixes[0].work, WorkState::kOn);
  EXPECT_EQ(log.fixes[1].work, WorkState::kOff);
}

// Seed and fertiliser are switched by themselves, each in two sections over the same land.
TEST(LoggedWidth, FunctionsWithSectionsEach) {
  Device drill;
  drill.add("DET-1", 1, 0);
  for (const std::string name : {"A", "B"}) {
    const long long function = drill.add("DET-" + name, 2, 1);
    drill.add("DET-" + name + "1", 4, function, {{kWidth, 3000}, {kAcross, -1500}});
    drill.add("DET-" + name + "2", 4, function, {{kWidth, 3000}, {kAcross, 1500}});
  }
  const std::string xml = header(R"(<DLV A="00A1" B="" C="DET-A"/><DLV A="00A1" B="" C="DET-B"/>)");
  const WorkLog log = decoded(xml, drill.elements(), {{{0, 0x1}, {1, 0x0}}, {{0, 0x0}, {1, 0x5}}});
  const Boom boom{{3, 0}, {3, 0}, {0, -3}, {0, -3}};
  EXPECT_EQ(log.booms.at(static_cast<std::size_t>(log.fixes[0].boom)), boom);
  EXPECT_EQ(log.fixes[0].sections.count(), 1U);
  EXPECT_TRUE(log.fixes[0].sections[0] || log.fixes[0].sections[1]);
  EXPECT_EQ(log.fixes[1].sections.count(), 2U);
}

TEST(LoggedWidth, SectionsWithoutOffsetsStandSideBySideInTheMiddleOfTheirFunction) {
  Device boom;
  boom.add("DET-1", 1, 0);
  boom.add("DET-2", 2, 1, {{kAcross, 1000}});
  boom.add("DET-3", 4, 2, {{kWidth, 2000}});
  boom.add("DET-4", 4, 2, {{kWidth, 4000}});
  EXPECT_EQ(boom_of(boom), (Boom{{2, -4}}));
  // Two wings of 6 m that say no place are one machine of 12 m.
  Device wings;
  wings.add("DET-1", 1, 0, {{70, 12000}});
  wings.add("DET-2", 2, 1, {{kWidth, 6000}});
  wings.add("DET-3", 2, 1, {{kWidth, 6000}});
  EXPECT_EQ(boom_of(wings), (Boom{{6, -6}}));
}

TEST(LoggedWidth, AWidthThatIsLoggedChangesWithTime) {
  Device header_of_harvester;
  header_of_harvester.add("DET-1", 1, 0);
  header_of_harvester.add("DET-2", 2, 1, {{70, 9000}});
  // Parts that are described and of which nothing is logged do not overrule it.
  header_of_harvester.add("DET-3", 4, 2, {{kWidth, 4500}, {kAcross, -2250}});
  header_of_harvester.add("DET-4", 4, 2, {{kWidth, 4500}, {kAcross, 2250}});
  const std::string xml = header(R"(<DLV A="008D" B="" C="DET-1"/><DLV A="0043" B="" C="DET-2"/>)");
  const WorkLog log =
      decoded(xml, header_of_harvester.elements(), {{{0, 1}}, {{1, 6000}}, {{1, 3000}}, {{1, 0}}});
  const auto boom = [&](std::size_t fix) {
    return log.booms.at(static_cast<std::size_t>(log.fixes[fix].boom));
  };
  EXPECT_EQ(boom(0), (Boom{{4.5, -4.5}}));
  EXPECT_EQ(boom(1), (Boom{{3, -3}}));
  EXPECT_EQ(boom(2), (Boom{{1.5, -1.5}}));
  EXPECT_EQ(boom(3), Boom{});
}

TEST(LoggedWidth, SeveralDevicesWorkTheLandOfEach) {
  Device front("DVC-F"), rear("DVC-R"), tractor("DVC-T");
  front.add("DET-F", 1, 0, {{kWidth, 3000}});
  rear.add("DET-R", 1, 0, {{kWidth, 6000}});
  tractor.add("DET-T", 1, 0);
  std::vector<DeviceElement> elements = front.elements();
  elements.insert(elements.end(), rear.elements().begin(), rear.elements().end());
  elements.insert(elements.end(), tractor.elements().begin(), tractor.elements().end());
  const std::string xml = header(R"(<DLV A="008D" B="" C="DET-F"/><DLV A="008D" B="" C="DET-R"/>)"
                                 R"(<DLV A="008D" B="" C="DET-T"/>)");
  const WorkLog log = decoded(xml, elements, {{{0, 1}, {1, 0}, {2, 1}}, {{0, 0}, {1, 1}}});
  EXPECT_EQ(log.booms.at(static_cast<std::size_t>(log.fixes[0].boom)), (Boom{{3, -3}, {1.5, -1.5}}));
  EXPECT_EQ(log.fixes[0].sections, SectionStates("10"));
  EXPECT_EQ(log.fixes[1].sections, SectionStates("01"));
  ASSERT_EQ(log.notes.size(), 1U);
  EXPECT_TRUE(mentions(log.notes[0], "DVC-F, DVC-R")) << log.notes[0];
}

// The drill says how wide it is and the tractor when it works.
TEST(LoggedWidth, ATractorSwitchesAnImplementThatDoesNotTell) {
  Device drill("DVC-D"), tractor("DVC-T");
  drill.add("DET-D", 1, 0);
  tractor.add("DET-T", 1, 0);
  std::vector<DeviceElement> elements = drill.elements();
  elements.insert(elements.end(), tractor.elements().begin(), tractor.elements().end());
  const std::string xml = header(R"(<DLV A="0043" B="" C="DET-D"/><DLV A="008D" B="" C="DET-T"/>)");
  const WorkLog log = decoded(xml, elements, {{{0, 4000}, {1, 1}}, {{1, 0}}});
  EXPECT_EQ(log.booms.at(static_cast<std::size_t>(log.fixes[0].boom)), (Boom{{2, -2}}));
  EXPECT_EQ(log.fixes[0].work, WorkState::kOn);
  EXPECT_EQ(log.fixes[1].work, WorkState::kOff);
}

TEST(LoggedWidth, SectionsOfAPlanterSwitchTheirRows) {
  Device rows;
  rows.add("DET-1", 1, 0);
  for (int section = 0; section < 2; ++section) {
    const long long object = rows.add("DET-S" + std::to_string(section), 4, 1);
    for (int row = 0; row < 4; ++row)
      rows.add("DET-R" + std::to_string(4 * section + row), 5, object,
               {{kWidth, 500}, {kAcross, 500 * (4 * section + row) - 1750}});
  }
  const std::string xml = header(R"(<DLV A="00A1" B="" C="DET-1"/>)");
  const WorkLog log = decoded(xml, rows.elements(), {{{0, 0x4}}});
  EXPECT_EQ(log.booms.at(static_cast<std::size_t>(log.fixes[0].boom)), (Boom{{2, 0}, {0, -2}}));
  EXPECT_EQ(log.fixes[0].sections, SectionStates("10"));
}

TEST(LoggedWidth, ElementsThatContainOneAnotherInACircle) {
  const std::vector<DeviceElement> elements = {{"DET-1", "DVC-1", 1, 1, 2, 1, {}},
                                               {"DET-2", "DVC-1", 4, 2, 1, 2, {{kWidth, 4000}}}};
  const DeviceTree tree(elements);
  EXPECT_EQ(tree.devices().size(), 1U);
  const WorkLog log = decoded(kState, elements);
  EXPECT_EQ(log.booms.at(static_cast<std::size_t>(log.fixes[0].boom)), (Boom{{2, -2}}));
}

}  // namespace tramline::io::logged_width_test
