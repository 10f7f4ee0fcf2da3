// Headers and records of time logs, written by hand.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "io/isoxml/time_log_bytes.h"
#include "support/refusals.h"
#include "tramline/geometry/error.h"
#include "tramline/io/isoxml/time_log.h"

namespace tramline::io::time_log_test {

using testing_support::mentions;
using testing_support::refusal_of;

using testing_logs::header;
using testing_logs::little;
using testing_logs::little_signed;
using testing_logs::record;
using testing_logs::values_of;

// 2020-01-02 is day 14,611 from 1980-01-01 (40 years, 10 leap days, and one) and day 18,263 from 1970.
constexpr std::uint32_t kDay = 14611;
constexpr double kDay_s = 18263 * 86400.0;
constexpr std::int32_t kLat = 545822941, kLon = 102119904;

WorkLog decode(const std::string& xml, const std::string& bytes,
               const std::vector<DeviceElement>& elements = {}) {
  return decode_time_log(xml, bytes, elements, "'t.zip', TLG00001");
}

std::string refusal(const std::string& xml) {
  return refusal_of([&] { decode(xml, ""); });
}

TEST(TimeLog, PositionsAndTimes) {
  const WorkLog log = decode(header(""), record(63020500, kDay, kLat, kLon, 4));
  ASSERT_EQ(log.fixes.size(), 1U);
  EXPECT_DOUBLE_EQ(log.fixes[0].time_s, kDay_s + 63020.5);
  EXPECT_EQ(log.clock, Clock::kUtc);
  EXPECT_NEAR(log.fixes[0].position.y, 54.5822941, 1e-12);
  EXPECT_NEAR(log.fixes[0].position.x, 10.2119904, 1e-12);
  EXPECT_TRUE(std::isnan(log.fixes[0].heading.degrees()));
  EXPECT_TRUE(std::isnan(log.fixes[0].speed_mps));
}

TEST(TimeLog, SouthAndWest) {
  const WorkLog log = decode(header(""), record(0, kDay, -147699982, -505100000, 4));
  EXPECT_NEAR(log.fixes.at(0).position.y, -14.7699982, 1e-12);
  EXPECT_NEAR(log.fixes.at(0).position.x, -50.51, 1e-12);
}

TEST(TimeLog, AllPartsOfAPositionStandInTheirOrder) {
  const std::string xml = header("", R"(<PTN I="" H="" G="" F="" E="" D="" C="" B="" A=""/>)");
  const std::string one = little(1000, 4) + little(kDay, 2) + little_signed(kLat) + little_signed(kLon) +
                          little_signed(123456) + little(4, 1) + little(6, 2) + little(10, 2) +
                          little(11, 1) + little(66580000, 4) + little(kDay, 2) + values_of({});
  const WorkLog log = decode(xml, one + one + one);
  ASSERT_EQ(log.fixes.size(), 3U);
  EXPECT_NEAR(log.fixes[2].position.y, 54.5822941, 1e-12);
  EXPECT_EQ(log.skipped.count, 0U);
}

TEST(TimeLog, OnlyEmptyAttributesAreInTheRecords) {
  // D is given in the header and C is not there at all.
  const std::string xml = header("", R"(<PTN A="" B="" D="4"/>)");
  const std::string one =
      little(1000, 4) + little(kDay, 2) + little_signed(kLat) + little_signed(kLon) + values_of({});
  EXPECT_EQ(decode(xml, one + one).fixes.size(), 2U);
}

TEST(TimeLog, WorkAndWidthHoldUntilTheyChange) {
  const std::string xml = header(R"(<DLV A="0043" B="" C="DET-2"/><DLV A="008d" B="" C="DET-1"/>)");
  const WorkLog log = decode(xml, record(1000, kDay, kLat, kLon, 4) +
                                      record(2000, kDay, kLat, kLon + 9, 4, {{0, 9000}, {1, 0}}) +
                                      record(3000, kDay, kLat, kLon + 18, 4, {{1, 1}}) +
                                      record(4000, kDay, kLat, kLon + 27, 4, {{0, 8250}}) +
                                      record(5000, kDay, kLat, kLon + 36, 4, {{1, 3}}) +
                                      record(5000, kDay, kLat, kLon + 45, 4, {{0, 0}, {1, 1}}));
  ASSERT_EQ(log.fixes.size(), 6U);
  EXPECT_EQ(log.fixes[0].boom, -1);
  EXPECT_EQ(log.fixes[0].work, WorkState::kUnknown);
  EXPECT_EQ(log.fixes[1].work, WorkState::kOff);
  EXPECT_EQ(log.fixes[2].work, WorkState::kOn);
  EXPECT_EQ(log.fixes[3].work, WorkState::kOn);
  EXPECT_EQ(log.fixes[4].work, WorkState::kUnknown);
  EXPECT_EQ(log.booms, (std::vector<Boom>{{{4.5, -4.5}}, {{4.125, -4.125}}, {}}));
  EXPECT_EQ(log.fixes[2].boom, 0);
  EXPECT_EQ(log.fixes[3].boom, 1);
  EXPECT_EQ(log.fixes[4].boom, 1);
  EXPECT_EQ(log.fixes[5].boom, 2);
}

TEST(TimeLog, AppliedRatesHoldUntilTheyChange) {
  struct Case {
    const char* ddi;
    std::int32_t value;
    double per_ha;
    AmountUnit unit;
  };
  // 200 l/ha are 20 ml/m², 20 000 mm³/m²; 150 kg/ha are 15 g/m²; 80 000 seeds/ha are 8/m².
  for (const Case& c :
       {Case{"0002", 2000000, 200, AmountUnit::kLitres}, Case{"0007", 15000, 150, AmountUnit::kKilograms},
        Case{"000C", 8000, 80000, AmountUnit::kSeeds}}) {
    const std::string xml = header(R"(<DLV A="0001" B="" C="DET-1"/><DLV A=")" + std::string(c.ddi) +
                                   R"(" B="" C="DET-1"/><DLV A="0002" B="" C="DET-2"/>)");
    const WorkLog log = decode(xml, record(0, kDay, kLat, kLon, 4, {{0, 77}}) +
                                        record(1000, kDay, kLat, kLon, 4, {{1, c.value}, {2, 5}}) +
                                        record(2000, kDay, kLat, kLon, 4) +
                                        record(3000, kDay, kLat, kLon, 4, {{1, -2147483647}}));
    ASSERT_EQ(log.fixes.size(), 4U);
    EXPECT_EQ(log.rate_unit, c.unit);
    EXPECT_TRUE(std::isnan(log.fixes[0].rate_per_ha));  // a setpoint is not what was applied
    EXPECT_NEAR(log.fixes[1].rate_per_ha, c.per_ha, 1e-9);
    EXPECT_NEAR(log.fixes[2].rate_per_ha, c.per_ha, 1e-9);
    EXPECT_TRUE(std::isnan(log.fixes[3].rate_per_ha));
  }
}

TEST(TimeLog, RecordsWithoutAPositionAreListed) {
  const std::string bytes = record(1000, kDay, kLat, kLon, 4) + record(2000, kDay, 0, 0, 4) +
                            record(3000, kDay, 2147483647, kLon, 4) +
                            record(4000, kDay, kLat, 2147483647, 4) + record(5000, kDay, kLat, kLon, 0) +
                            record(6000, kDay, kLat, kLon, 14) + record(7000, kDay, kLat, kLon, 15);
  const WorkLog log = decode(header(""), bytes);
  EXPECT_EQ(log.fixes.size(), 2U);
  ASSERT_EQ(log.skipped.count, 5U);
  EXPECT_EQ(log.skipped.listed[1].record, 3U);
  EXPECT_TRUE(mentions(log.skipped.listed[1].why, "latitude 214.7"));
  EXPECT_EQ(log.fixes[1].record, 7U);
}

TEST(TimeLog, ValuesOfSkippedRecordsCount) {
  const std::string xml = header(R"(<DLV A="008D" B="" C="DET-1"/>)");
  const WorkLog log = decode(xml, record(1000, kDay, 0, 0, 4, {{0, 1}}) + record(2000, kDay, kLat, kLon, 4));
  EXPECT_EQ(log.fixes.at(0).work, WorkState::kOn);
}

TEST(TimeLog, ACutOffRecordIsTold) {
  const std::string whole = record(1000, kDay, kLat, kLon, 4) + record(2000, kDay, kLat, kLon, 4);
  for (std::size_t size = 17; size < whole.size(); ++size) {
    const WorkLog log = decode(header(""), whole.substr(0, size));
    EXPECT_EQ(log.fixes.size(), 1U) << size;
    ASSERT_EQ(log.skipped.count, 1U) << size;
    EXPECT_TRUE(mentions(log.skipped.listed[0].why, "cut off")) << log.skipped.listed[0].why;
  }
}

TEST(TimeLog, LostBytesCostTheRecordThatLostThem) {
  const std::string xml = header(R"(<DLV A="008D" B="" C="DET-1"/>)");
  std::string bytes;
  std::vector<std::size_t> starts;
  for (int i = 0; i < 20; ++i) {
    starts.push_back(bytes.size());
    bytes += record(static_cast<std::uint32_t>(60000000 + 1000 * i), kDay, kLat + 100 * i, kLon, 4, {{0, 1}});
  }
  for (std::size_t lost = starts[10]; lost < starts[11]; ++lost) {
    std::string damaged = bytes;
    damaged.erase(lost, 1);
    const WorkLog log = decode(xml, damaged);
    EXPECT_GE(log.fixes.size(), 18U) << lost;
    EXPECT_LE(log.fixes.size(), 20U) << lost;
    // The last ones are read as they were written.
    EXPECT_NEAR(log.fixes.back().position.y, (kLat + 1900) / 1e7, 1e-12) << lost;
    EXPECT_DOUBLE_EQ(log.fixes.back().time_s, kDay_s + 60019) << lost;
  }
}

TEST(TimeLog, HeadersThatCannotBeRead) {
  EXPECT_TRUE(mentions(refusal("<TIM A=\"\""), "damaged XML"));
  EXPECT_TRUE(mentions(refusal("<TSK/>"), "TIM"));
  EXPECT_TRUE(mentions(refusal(R"(<TIM A="2020-01-01T00:00:00"><PTN A="" B=""/></TIM>)"), "times"));
  EXPECT_TRUE(mentions(refusal(R"(<TIM A=""></TIM>)"), "PTN"));
  EXPECT_TRUE(mentions(refusal(header(R"(<DLV A="xyz" B="" C="DET-1"/>)")), "xyz"));
  std::string many;
  for (int i = 0; i < 256; ++i) many += R"(<DLV A="0001" B="" C="DET-1"/>)";
  EXPECT_TRUE(mentions(refusal(header(many)), "255"));
}

/// Device with the given sections: number, offset to the right (nullopt: none), width, mm.
struct SectionText {
  long long number;
  std::optional<long long> right_mm;
  std::optional<long long> width_mm;
};
std::vector<DeviceElement> device(const std::vector<SectionText>& sections) {
  std::vector<DeviceElement> out(1);
  out[0] = {"DET-1", "DVC-1", 1, 0, 0, 1, {}};
  for (const SectionText& text : sections) {
    DeviceElement element = {
        "DET-S" + std::to_string(text.number), "DVC-1", 4, text.number, 1, 10 + text.number, {}};
    if (text.right_mm) element.properties[135] = *text.right_mm;
    if (text.width_mm) element.properties[67] = *text.width_mm;
    out.push_back(element);
  }
  return out;
}

const std::string kCondensed = header(R"(<DLV A="00A1" B="" C="DET-1"/>)");

TEST(TimeLog, CondensedStatesCountSectionsByTheirNumbers) {
  // Described out of order; numbers 1, 2, 3 from left to right, 1 m, 2 m and 3 m wide.
  const auto elements = device({{3, 1500, 3000}, {1, -2500, 1000}, {2, -1000, 2000}});
  // Section 1 on, 2 off, 3 on, the rest not installed.
  const std::int32_t bits = static_cast<std::int32_t>(0xFFFFFFC0 | 0x11);
  const WorkLog log = decode(kCondensed, record(1000, kDay, kLat, kLon, 4, {{0, bits}}), elements);
  ASSERT_EQ(log.booms.size(), 1U);
  EXPECT_EQ(log.booms[0], (Boom{{3, 2}, {2, 0}, {0, -3}}));
  EXPECT_TRUE(log.fixes[0].has_sections);
  EXPECT_EQ(log.fixes[0].sections, SectionStates("101"));
  EXPECT_EQ(log.fixes[0].work, WorkState::kOn);
}

TEST(TimeLog, SectionsNumberedFromTheRightAreTurned) {
  const auto elements = device({{1, 1500, 3000}, {2, -1500, 3000}});
  const WorkLog log = decode(kCondensed, record(1000, kDay, kLat, kLon, 4, {{0, 0x1}}), elements);
  EXPECT_EQ(log.booms.at(0), (Boom{{3, 0}, {0, -3}}));
  // Number 1 is the right one.
  EXPECT_EQ(log.fixes[0].sections, SectionStates("10"));
}

TEST(TimeLog, SectionsWithoutOffsetsStandSideBySide) {
  const auto elements = device({{1, std::nullopt, 1000}, {2, std::nullopt, 3000}});
  const WorkLog log = decode(kCondensed, record(1000, kDay, kLat, kLon, 4, {{0, 0x4}}), elements);
  EXPECT_EQ(log.booms.at(0), (Boom{{2, 1}, {1, -2}}));
  EXPECT_EQ(log.fixes[0].sections, SectionStates("10"));
}

TEST(TimeLog, SectionsShareTheWidthOfTheMachine) {
  const std::string xml = header(R"(<DLV A="00A1" B="" C="DET-1"/><DLV A="0043" B="" C="DET-1"/>)");
  const auto elements = device({{1, std::nullopt, std::nullopt}, {2, std::nullopt, std::nullopt}});
  const WorkLog log = decode(xml, record(1000, kDay, kLat, kLon, 4, {{0, 0x1}, {1, 6000}}), elements);
  EXPECT_EQ(log.booms.at(0), (Boom{{3, 0}, {0, -3}}));
  EXPECT_EQ(log.fixes[0].sections, SectionStates("01"));
}

TEST(TimeLog, MoreThanSixteenSections) {
  std::vector<SectionText> sections;
  for (int i = 0; i < 18; ++i) sections.push_back({i + 1, -8500 + 1000 * i, 1000});
  const std::string xml = header(R"(<DLV A="00A1" B="" C="DET-1"/><DLV A="00A2" B="" C="DET-1"/>)");
  const WorkLog log = decode(xml, record(1000, kDay, kLat, kLon, 4, {{0, 0}, {1, 0x4}}), device(sections));
  EXPECT_EQ(log.booms.at(0).size(), 18U);
  EXPECT_EQ(log.fixes[0].sections.count(), 1U);
  EXPECT_TRUE(log.fixes[0].sections[17]);
}

TEST(TimeLog, SetpointsAreNotWhatWasDone) {
  const std::string xml = header(R"(<DLV A="0122" B="" C="DET-1"/>)");  // 290
  const auto elements = device({{1, -500, 1000}, {2, 500, 1000}});
  const WorkLog log = decode(xml, record(1000, kDay, kLat, kLon, 4, {{0, 0x5}}), elements);
  EXPECT_FALSE(log.fixes.at(0).has_sections);
  EXPECT_EQ(log.fixes[0].work, WorkState::kUnknown);
}

TEST(TimeLog, StatesOfSectionsOneByOne) {
  const std::string xml = header(
      R"(<DLV A="008D" B="" C="DET-S1"/><DLV A="008D" B="" C="DET-S2"/><DLV A="0087" B="" C="DET-S1"/>)"
      R"(<DLV A="0087" B="" C="DET-S2"/><DLV A="008D" B="" C="DET-1"/>)");
  const auto elements = device({{1, std::nullopt, 3000}, {2, std::nullopt, 3000}});
  const WorkLog log = decode(xml,
                             record(1000, kDay, kLat, kLon, 4, {{0, 1}, {2, 1500}, {3, -1500}}) +
                                 record(2000, kDay, kLat, kLon, 4, {{4, 0}}),
                             elements);
  // The logged offsets say that the first stands on the right. The second was not heard of yet: off.
  EXPECT_EQ(log.booms.at(static_cast<std::size_t>(log.fixes.at(0).boom)), (Boom{{3, 0}, {0, -3}}));
  EXPECT_EQ(log.fixes[0].sections, SectionStates("10"));
  EXPECT_EQ(log.fixes[0].work, WorkState::kOn);
  EXPECT_EQ(log.fixes[1].work, WorkState::kOff);
}

TEST(TimeLog, TheDeviceThatTellsMoreCounts) {
  auto elements = device({{1, -500, 1000}, {2, 500, 1000}});
  elements.push_back({"DET-9", "DVC-2", 1, 0, 0, 1, {}});
  const std::string xml = header(R"(<DLV A="008D" B="" C="DET-9"/><DLV A="008D" B="" C="DET-1"/>)"
                                 R"(<DLV A="00A1" B="" C="DET-1"/>)");
  const WorkLog log = decode(xml, record(1000, kDay, kLat, kLon, 4, {{0, 0}, {1, 1}, {2, 0x1}}), elements);
  EXPECT_EQ(log.fixes.at(0).work, WorkState::kOn);
  ASSERT_FALSE(log.notes.empty());
  EXPECT_TRUE(mentions(log.notes[0], "DVC-1"));
}

}  // namespace tramline::io::time_log_test
