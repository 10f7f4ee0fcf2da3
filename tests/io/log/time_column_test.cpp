#include "tramline/io/log/time_column.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tramline/io/fixes/civil_time.h"

namespace tramline::io {
namespace {

// 18,263 days lie before 2020-01-02: 50 years of 365 days, 12 leap days, and one.
constexpr double k20200102 = 18263 * 86400.0;

TEST(CivilTime, DatesThatThereAreAndAreNot) {
  EXPECT_EQ(days_to(1970, 1, 1), 0);
  EXPECT_EQ(days_to(1980, 1, 1), 3652);
  EXPECT_EQ(days_to(2020, 1, 2), 18263);
  EXPECT_EQ(*days_to(2024, 3, 1) - *days_to(2024, 2, 28), 2);
  EXPECT_EQ(*days_to(1900, 3, 1) - *days_to(1900, 2, 28), 1);
  EXPECT_FALSE(days_to(2023, 2, 29));
  EXPECT_FALSE(days_to(2023, 13, 1));
  EXPECT_FALSE(days_to(99999, 1, 1));
}

TEST(CivilTime, Zones) {
  EXPECT_EQ(date_time_s("2020-01-02T17:30:20.5Z"), k20200102 + 63020.5);
  EXPECT_EQ(date_time_s("2020-01-02 17:30:20"), k20200102 + 63020);
  EXPECT_EQ(date_time_s("2020-01-02T17:30+01:30"), k20200102 + 63000 - 5400);
  EXPECT_EQ(date_time_s("2020-01-02T17:30-0530"), k20200102 + 63000 + 19800);
  EXPECT_EQ(date_time_s("2020/01/02 17:30:00+01"), k20200102 + 63000 - 3600);
  EXPECT_EQ(date_time_s("02.01.2020 17:30:00"), k20200102 + 63000);
  EXPECT_EQ(date_time_s("2020-01-02"), k20200102);
  for (const char* wrong :
       {"", "T", "2020-01-02T", "2020-01-02T25:00", "2020-01-02T10:60", "2020-01-02T10:00+",
        "2020-01-02T10:00+1", "2020-01-02T10:00:61", "2020-1-", "01/02/2020", "17:30:20", "-2020-01-02"})
    EXPECT_FALSE(date_time_s(wrong)) << wrong;
}

TEST(TimeColumn, TheFirstTimeDecides) {
  TimeColumn iso;
  EXPECT_EQ(iso.clock(), Clock::kNone);
  EXPECT_TRUE(std::isnan(iso.time_s("")));
  EXPECT_EQ(iso.time_s("2020-01-02T00:00:00"), k20200102);
  EXPECT_TRUE(std::isnan(iso.time_s("17")));
  EXPECT_EQ(iso.clock(), Clock::kUtc);
}

TEST(TimeColumn, NumbersAreSecondsOrMilliseconds) {
  TimeColumn seconds, milliseconds, small, named(1e-3);
  EXPECT_EQ(seconds.time_s("1577923200.25"), k20200102 + 0.25);
  EXPECT_EQ(seconds.clock(), Clock::kUtc);
  EXPECT_EQ(milliseconds.time_s("1577923200250"), k20200102 + 0.25);
  EXPECT_EQ(milliseconds.clock(), Clock::kUtc);
  EXPECT_EQ(small.time_s("1.5"), 1.5);
  EXPECT_EQ(small.clock(), Clock::kOther);
  EXPECT_EQ(named.time_s("1500"), 1.5);
}

TEST(TimeColumn, TimesOfDayRunOnOverMidnight) {
  TimeColumn time;
  EXPECT_EQ(time.time_s("23:59:59"), 86399);
  EXPECT_EQ(time.time_s("00:00:01.5"), 86401.5);
  // A record out of order is no midnight.
  EXPECT_EQ(time.time_s("00:00:01"), 86401);
  EXPECT_EQ(time.clock(), Clock::kOfDay);
}

TEST(TimeColumn, ADateBesideATimeOfDay) {
  TimeColumn time;
  EXPECT_EQ(time.time_s("00:00:10", "02.01.2020"), k20200102 + 10);
  EXPECT_EQ(time.clock(), Clock::kUtc);
}

}  // namespace
}  // namespace tramline::io
