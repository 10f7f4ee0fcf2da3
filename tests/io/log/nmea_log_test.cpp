// Sentences of receivers, and their epochs.

#include "tramline/io/log/nmea_log.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tramline/geometry/error.h"

namespace tramline::io::nmea_log_test {

// The examples that most descriptions of NMEA 0183 give, with their checksums.
const std::string kGga = "$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47";
const std::string kRmc = "$GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W*6A";

std::string sentence(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  return fmt::format("${}*{:02X}", body, sum);
}

std::string gga(const std::string& time, int quality = 4) {
  return sentence(fmt::format("GNGGA,{},4807.038,N,01131.000,E,{},08,0.9,545.4,M,46.9,M,,", time, quality));
}

WorkLog nmea(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& one : sentences) text += one + "\r\n";
  TextLines lines(text);
  return read_nmea_log(lines, "'t.nmea'");
}

TEST(NmeaLog, TheExamplesOfTheTextbooks) {
  const WorkLog log = nmea({kGga, kRmc});
  ASSERT_EQ(log.fixes.size(), 1U);
  const Fix& fix = log.fixes[0];
  EXPECT_NEAR(fix.position.y, 48 + 7.038 / 60, 1e-12);
  EXPECT_NEAR(fix.position.x, 11 + 31.0 / 60, 1e-12);
  // 23 March 1994 is day 8,847 from 1970; 12:35:19 is second 45,319.
  EXPECT_DOUBLE_EQ(fix.time_s, 8847 * 86400.0 + 45319);
  EXPECT_EQ(log.clock, Clock::kUtc);
  EXPECT_NEAR(fix.speed_mps, 22.4 * 1852 / 3600, 1e-12);
  EXPECT_NEAR(fix.heading.degrees(), 84.4, 1e-9);
  EXPECT_EQ(fix.record, 1U);
  EXPECT_EQ(log.skipped.count, 0U);
}

// Table 5 of NMEA 0183: 1 GPS, 2 differential, 4 RTK with whole cycles, 5 RTK float, 6 dead reckoning; of RMC
// the mode A, D, R, F, E.
TEST(NmeaLog, SaysHowThePositionWasGot) {
  const auto after = [](const std::vector<std::string>& sentences) {
    NmeaLog log;
    for (const std::string& one : sentences) log.add(one);
    log.finish();
    return log.quality();
  };
  EXPECT_EQ(NmeaLog().quality(), FixQuality::kUnknown);
  EXPECT_EQ(after({gga("120000.00", 1)}), FixQuality::kSingle);
  EXPECT_EQ(after({gga("120000.00", 2)}), FixQuality::kDifferential);
  EXPECT_EQ(after({gga("120000.00", 4)}), FixQuality::kRtkFixed);
  EXPECT_EQ(after({gga("120000.00", 5)}), FixQuality::kRtkFloat);
  EXPECT_EQ(after({gga("120000.00", 6)}), FixQuality::kEstimated);
  EXPECT_EQ(after({gga("120000.00", 4), gga("120001.00", 5)}), FixQuality::kRtkFloat) << "the last counts";
  const std::string rmc = "GNRMC,120000,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W";
  EXPECT_EQ(after({sentence(rmc)}), FixQuality::kUnknown) << "older than the mode";
  EXPECT_EQ(after({sentence(rmc + ",R")}), FixQuality::kRtkFixed);
  EXPECT_EQ(after({sentence(rmc + ",F")}), FixQuality::kRtkFloat);
  EXPECT_EQ(after({sentence(rmc + ",A")}), FixQuality::kSingle);
  EXPECT_EQ(after({gga("120000", 4), sentence(rmc + ",A")}), FixQuality::kRtkFixed) << "GGA says more";
  EXPECT_STREQ(name(FixQuality::kRtkFixed), "rtk fixed");
}

TEST(NmeaLog, SouthAndWestAreNegative) {
  const WorkLog log = nmea({sentence("GPGGA,000000,3330.0,S,07015.0,W,1,08,0.9,0,M,0,M,,")});
  EXPECT_NEAR(log.fixes[0].position.y, -33.5, 1e-12);
  EXPECT_NEAR(log.fixes[0].position.x, -70.25, 1e-12);
  EXPECT_EQ(log.clock, Clock::kOfDay);
}

TEST(NmeaLog, AnEpochEndsWhenTheNextBegins) {
  NmeaLog live;
  EXPECT_FALSE(live.add(gga("100000.00")));
  EXPECT_FALSE(live.add(sentence("GNVTG,90.0,T,,M,3.0,N,5.6,K")));
  EXPECT_FALSE(live.add(sentence("GNHDT,45.5,T")));
  const auto first = live.add(gga("100000.20"));
  ASSERT_TRUE(first);
  EXPECT_DOUBLE_EQ(first->time_s, 36000);
  EXPECT_NEAR(first->speed_mps, 3.0 * 1852 / 3600, 1e-12);
  EXPECT_NEAR(first->heading.degrees(), 45.5, 1e-9);  // rather than the course
  const auto last = live.finish();
  ASSERT_TRUE(last);
  EXPECT_DOUBLE_EQ(last->time_s, 36000.2);
  EXPECT_TRUE(std::isnan(last->speed_mps));
  EXPECT_FALSE(live.finish());
}

TEST(NmeaLog, ACourseIsNoHeadingWhileTheMachineStands) {
  // 0.9 knots are 0.463 m/s, 1.0 knots 0.514.
  const WorkLog log = nmea({gga("100000"), sentence("GNVTG,90.0,T,,M,0.9,N,1.7,K"), gga("100001"),
                            sentence("GNVTG,90.0,T,,M,1.0,N,1.9,K"), gga("100002"), sentence("GNTHS,200.5,A"),
                            gga("100003"), sentence("GNTHS,200.5,V")});
  ASSERT_EQ(log.fixes.size(), 4U);
  EXPECT_TRUE(std::isnan(log.fixes[0].heading.degrees()));
  EXPECT_NEAR(log.fixes[1].heading.degrees(), 90, 1e-9);
  EXPECT_NEAR(log.fixes[2].heading.degrees(), 200.5, 1e-9);
  EXPECT_TRUE(std::isnan(log.fixes[3].heading.degrees()));
}

TEST(NmeaLog, WhatIsNotRightIsCounted) {
  std::string wrong = gga("100001");
  wrong[15] = wrong[15] == '4' ? '5' : '4';
  std::string cut = gga("100004");
  cut.resize(30);
  const WorkLog log =
      nmea({"# receiver 7", "", gga("100000"), wrong, gga("100002", 0), sentence("GNRMC,100003,V,,,,,,,,,"),
            sentence("GNGGA,100005,9907.0,N,01131.0,E,1,,,,,,,,"), sentence("GNGSV,1,1,00"),
            "!AIVDM,1,1,,A,x,0*00", cut});
  EXPECT_EQ(log.fixes.size(), 1U);
  // The remark, the wrong checksum, no position twice, a latitude of 99 degrees, and the cut sentence.
  EXPECT_EQ(log.skipped.count, 6U);
  ASSERT_GE(log.skipped.listed.size(), 2U);
  EXPECT_EQ(log.skipped.listed[0].record, 1U);
  EXPECT_EQ(log.skipped.listed[1].record, 4U);
  EXPECT_EQ(log.skipped.listed[1].why, "the checksum is wrong");
}

TEST(NmeaLog, SentencesBehindTimeStampsAndRunTogether) {
  const WorkLog log = nmea({"12:35:19.123 > " + kGga, "$GPGGA,1235" + gga("123520")});
  ASSERT_EQ(log.fixes.size(), 2U);
  EXPECT_DOUBLE_EQ(log.fixes[1].time_s - log.fixes[0].time_s, 1);
}

TEST(NmeaLog, ChecksumsMayBeMissingAltogether) {
  const WorkLog log = nmea({"$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,"});
  EXPECT_EQ(log.fixes.size(), 1U);
}

TEST(NmeaLog, TheDateRunsOnOverMidnight) {
  const auto rmc = [](const std::string& time, const std::string& date) {
    return sentence("GPRMC," + time + ",A,4807.038,N,01131.000,E,2.0,84.4," + date + ",,");
  };
  // Day 18,262 is 2020-01-01. The second epoch has no date.
  const WorkLog log = nmea({rmc("235959", "311219"), gga("000000"), gga("000001"), rmc("000001", "010120"),
                            rmc("120000", "030120")});
  ASSERT_EQ(log.fixes.size(), 4U);
  EXPECT_DOUBLE_EQ(log.fixes[0].time_s, 18262 * 86400.0 - 1);
  EXPECT_DOUBLE_EQ(log.fixes[1].time_s, 18262 * 86400.0);
  EXPECT_DOUBLE_EQ(log.fixes[2].time_s, 18262 * 86400.0 + 1);
  EXPECT_DOUBLE_EQ(log.fixes[3].time_s, 18264 * 86400.0 + 43200);
}

TEST(NmeaLog, ADateThatComesLateHoldsForAll) {
  const WorkLog log = nmea({gga("235959"), gga("000000"), sentence("GPZDA,000000,01,01,2020,00,00")});
  ASSERT_EQ(log.fixes.size(), 2U);
  EXPECT_EQ(log.clock, Clock::kUtc);
  EXPECT_DOUBLE_EQ(log.fixes[0].time_s, 18262 * 86400.0 - 1);
  EXPECT_DOUBLE_EQ(log.fixes[1].time_s, 18262 * 86400.0);
}

TEST(NmeaLog, EpochsWithoutTimes) {
  const WorkLog log = nmea({gga(""), gga(""), gga("")});
  EXPECT_EQ(log.fixes.size(), 3U);
  EXPECT_EQ(log.clock, Clock::kNone);
  EXPECT_TRUE(std::isnan(log.fixes[2].time_s));
}

TEST(NmeaLog, AFileWithoutPositionsIsRefused) {
  try {
    nmea({sentence("GPGSV,1,1,00"), gga("100000", 0)});
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_NE(std::string(error.what()).find("t.nmea"), std::string::npos);
  }
}

}  // namespace tramline::io::nmea_log_test
