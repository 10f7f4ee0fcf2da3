// Tables of fixes: separators, names, units, and what goes wrong in real ones.

#include "tramline/io/log/csv_log.h"
#include "support/refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tramline/geometry/error.h"
#include "tramline/io/fixes/most_fixes.h"

namespace tramline::io::csv_log_test {

using testing_support::mentions;
using testing_support::refusal_of;

WorkLog csv(const std::string& text, const std::string& columns = "", const std::string& crs = "") {
  TextLines lines(text);
  return read_csv_log(lines, columns, crs, "'t.csv'");
}

std::string refusal(const std::string& text, const std::string& columns = "", const std::string& crs = "") {
  return refusal_of([&] { csv(text, columns, crs); });
}

bool notes_mention(const WorkLog& log, const std::string& part) {
  for (const std::string& note : log.notes)
    if (mentions(note, part)) return true;
  return false;
}

TEST(CsvLog, AQuotedFieldMayHoldManyLines) {
  // The second line opens and closes a pair of quotes, the third has a separator, the fourth ends the field.
  const WorkLog log =
      csv("note,lon,lat\n\"one\n\"\"two\"\", \"\"\n9,54\nend\",10.5,52.25\n\"x\"\"\n\",10.6,52.35\n");
  ASSERT_EQ(log.fixes.size(), 2U);
  EXPECT_EQ(log.fixes[0].position, (Point{10.5, 52.25}));
  EXPECT_EQ(log.fixes[0].record, 2U);
  EXPECT_EQ(log.fixes[1].position, (Point{10.6, 52.35}));
  EXPECT_EQ(log.fixes[1].record, 6U);
}

// Two rows of one way in all the ways of writing them.
void expect_two_fixes(const WorkLog& log) {
  ASSERT_EQ(log.fixes.size(), 2U);
  EXPECT_EQ(log.positions, Positions::kLonLat);
  EXPECT_EQ(log.fixes[0].position, (Point{10.5, 52.25}));
  EXPECT_EQ(log.fixes[1].position, (Point{10.6, 52.35}));
  EXPECT_DOUBLE_EQ(log.fixes[1].speed_mps, 1.5);
}

TEST(CsvLog, CommasSemicolonsAndTabs) {
  expect_two_fixes(csv("lon,lat,speed\n10.5,52.25,1\n10.6,52.35,1.5\n"));
  expect_two_fixes(csv("lon;lat;speed\n10.5;52.25;1\n10.6;52.35;1.5\n"));
  expect_two_fixes(csv("lon\tlat\tspeed\n10.5\t52.25\t1\n10.6\t52.35\t1.5\n"));
  expect_two_fixes(csv("sep=;\nlon;lat;speed\n10.5;52.25;1\n10.6;52.35;1.5"));
}

TEST(CsvLog, DecimalCommasStandWithSemicolons) {
  expect_two_fixes(csv("lon;lat;speed\n10,5;52,25;1\n10,6;52,35;1,5\n"));
  // Neither a thousands separator nor a decimal one: no number.
  EXPECT_TRUE(mentions(refusal("lon;lat\n1.010,5;52,25\n"), "no row with a position"));
}

TEST(CsvLog, AppliedRatesComeInAmountsAHectare) {
  const WorkLog litres = csv("lon,lat,Applied rate (l/ha)\n10.5,52.25,180\n10.6,52.35,\n10.7,52.4,-3\n");
  ASSERT_EQ(litres.fixes.size(), 3U);
  EXPECT_EQ(litres.rate_unit, AmountUnit::kLitres);
  EXPECT_DOUBLE_EQ(litres.fixes[0].rate_per_ha, 180);
  EXPECT_TRUE(std::isnan(litres.fixes[1].rate_per_ha));
  EXPECT_TRUE(std::isnan(litres.fixes[2].rate_per_ha));
  EXPECT_TRUE(notes_mention(litres, "no applied rate"));
  // An acre is 0.4047 ha, a gallon 3.785 l, a pound 0.4536 kg.
  const WorkLog gallons = csv("lon,lat,rate_gal_ac\n10.5,52.25,10\n");
  EXPECT_NEAR(gallons.fixes[0].rate_per_ha, 93.5396, 1e-4);
  EXPECT_EQ(gallons.rate_unit, AmountUnit::kLitres);
  const WorkLog pounds = csv("lon,lat,dose\n10.5,52.25,100\n", "rate_lb_ac=dose");
  EXPECT_NEAR(pounds.fixes[0].rate_per_ha, 112.0851, 1e-4);
  EXPECT_EQ(pounds.rate_unit, AmountUnit::kKilograms);
  const WorkLog bare = csv("lon,lat,rate\n10.5,52.25,7\n");
  EXPECT_DOUBLE_EQ(bare.fixes[0].rate_per_ha, 7);
  EXPECT_EQ(bare.rate_unit, AmountUnit::kUnknown);
  EXPECT_TRUE(std::isnan(csv("lon,lat,rate\n10.5,52.25,7\n", "rate=").fixes[0].rate_per_ha));
}

TEST(CsvLog, ByteOrderMarkCarriageReturnsCommentsAndQuotes) {
  expect_two_fixes(
      csv("\xEF\xBB\xBF# from a machine\r\n\r\n\"lon\",\"lat\",\"speed\",remark\r\n"
          "10.5,52.25,1,\"a, \"\"b\"\"\"\r\n// pause\r\n10.6,52.35,\"1.5\",x\r\n"));
}

TEST(CsvLog, AQuotedFieldMayRunOverLineEnds) {
  const WorkLog log = csv("remark,lon,lat,speed\n\"one\ntwo\",10.5,52.25,1\n,10.6,52.35,1.5\n");
  expect_two_fixes(log);
  EXPECT_EQ(log.fixes[0].record, 2U);
  EXPECT_EQ(log.fixes[1].record, 4U);
}

TEST(CsvLog, AQuoteThatIsNeverClosedIsTold) {
  const WorkLog log = csv("remark,lon,lat\n,10.5,52.25\n\"open,10.6,52.35\n");
  EXPECT_EQ(log.fixes.size(), 1U);
  EXPECT_TRUE(notes_mention(log, "never closed"));
}

TEST(CsvLog, NamesOfColumns) {
  const WorkLog log =
      csv("Longitude (deg);LATITUDE;Speed [km/h];Heading;Working Width (mm)\n10,5;52;36;-90;6000\n");
  ASSERT_EQ(log.fixes.size(), 1U);
  EXPECT_DOUBLE_EQ(log.fixes[0].speed_mps, 10);
  EXPECT_NEAR(log.fixes[0].heading.degrees(), 270, 1e-9);
  ASSERT_EQ(log.booms.size(), 1U);
  EXPECT_EQ(log.booms[0], (Boom{{3, -3}}));
}

TEST(CsvLog, WantedColumnsComeFirst) {
  const std::string text = "lon,lat,Xc,Yc,T,w\n1,2,10.5,52.25,100,12\n";
  const WorkLog log = csv(text, "lon=Xc, lat=Yc,time=T,width_ft=w");
  EXPECT_EQ(log.fixes[0].position, (Point{10.5, 52.25}));
  EXPECT_DOUBLE_EQ(log.fixes[0].time_s, 100);
  EXPECT_NEAR(log.booms[0][0].left_m, 6 * 0.3048, 1e-12);
  // Left out on purpose.
  EXPECT_TRUE(std::isnan(csv("lon,lat,speed\n1,2,3\n", "speed=").fixes[0].speed_mps));
}

TEST(CsvLog, MissingColumnsAreNamedWithThoseFound) {
  const std::string sentence = refusal("lon,breite,T\n1,2,3\n");
  EXPECT_TRUE(mentions(sentence, "no column 'lat'")) << sentence;
  EXPECT_TRUE(mentions(sentence, "found lon, breite, T")) << sentence;
  const std::string wanted = refusal("lon,lat\n1,2\n", "time=T");
  EXPECT_TRUE(mentions(wanted, "no column 'T'")) << wanted;
  EXPECT_TRUE(mentions(refusal("lon,lat\n1,2\n", "colour=c"), "colour"));
}

TEST(CsvLog, NumbersForAHeaderAreRefused) {
  EXPECT_TRUE(mentions(refusal("10.5,52.25,1\n10.6,52.35,2\n"), "names of the columns"));
}

TEST(CsvLog, EmptyFilesAndWideCharactersAreRefused) {
  EXPECT_TRUE(mentions(refusal(""), "empty"));
  EXPECT_TRUE(mentions(refusal("# nothing\n"), "empty"));
  EXPECT_TRUE(mentions(refusal("lon,lat\n"), "no row"));
  EXPECT_TRUE(mentions(refusal(std::string("\xFF\xFEl\0o\0n\0", 8)), "UTF-16"));
}

TEST(CsvLog, RowsWithoutAPositionAreCounted) {
  const WorkLog log = csv("lon,lat\n10,50\n,\nx,50\n10\n0,0\n10,97\n200,50\nnan,50\n10.0001,50\n");
  EXPECT_EQ(log.fixes.size(), 2U);
  EXPECT_EQ(log.skipped.count, 7U);
  EXPECT_EQ(log.fixes[1].record, 10U);
}

TEST(CsvLog, RecordsFarFromAllOthersAreSkipped) {
  // The 180th meridian runs through the first four.
  const WorkLog log =
      csv("lon,lat\n179.9999,50\n-179.9999,50\n179.9998,50\n-179.9998,50\n10,50\n179.9997,53\n");
  EXPECT_EQ(log.fixes.size(), 4U);
  ASSERT_EQ(log.skipped.count, 2U);
  EXPECT_EQ(log.skipped.listed[0].record, 6U);
  EXPECT_EQ(log.skipped.listed[1].record, 7U);
}

TEST(CsvLog, XAndYBeyondDegreesAreMetres) {
  const WorkLog log = csv("x,y\n0,0\n3,100\n500,100\n");
  EXPECT_EQ(log.positions, Positions::kLocal);
  EXPECT_EQ(log.fixes.size(), 3U);
  // 100 m by 50 m would be possible degrees one by one, but not of one field.
  EXPECT_EQ(csv("x,y\n0,0\n100,0\n100,50\n0,50\n").positions, Positions::kLocal);
  EXPECT_EQ(csv("x,y\n10.1,52.1\n10.2,52.1\n").positions, Positions::kLonLat);
  EXPECT_EQ(csv("easting,northing\n1,1\n2,2\n").positions, Positions::kLocal);
  EXPECT_EQ(csv("x,y\n1,1\n2,2\n", "", "none").positions, Positions::kLocal);
}

TEST(CsvLog, MetresUnderTheNamesOfDegreesAreRefused) {
  const std::string sentence = refusal("lon,lat\n600000,5800000\n600001,5800000\n");
  EXPECT_TRUE(mentions(sentence, "--log-crs")) << sentence;
}

TEST(CsvLog, ProjectedPositionsAreCarriedToLongitudeAndLatitude) {
  // On its central meridian UTM 32N has easting 500,000, and on the equator northing 0.
  const WorkLog log = csv("easting,northing\n500000,0\n500000,1\n", "", "EPSG:32632");
  EXPECT_EQ(log.positions, Positions::kLonLat);
  EXPECT_NEAR(log.fixes[0].position.x, 9, 1e-9);
  EXPECT_NEAR(log.fixes[0].position.y, 0, 1e-9);
  // A metre along the meridian is 1/110,574 of a degree there, less the 0.9996 of the grid.
  EXPECT_NEAR(log.fixes[1].position.y, 1 / 110574.3 / 0.9996, 1e-10);
  EXPECT_TRUE(mentions(refusal("x,y\n1,1\n", "", "EPSG:1"), "EPSG:1"));
}

TEST(CsvLog, WidthsOfSectionsStandSideBySide) {
  const WorkLog log =
      csv("lon,lat,width_mm,sections\n10,50,3000|4500|3000,101\n10,50,3000|0|3000,011\n10,50,,\n");
  ASSERT_EQ(log.booms.size(), 2U);
  EXPECT_EQ(log.booms[0], (Boom{{5.25, 2.25}, {2.25, -2.25}, {-2.25, -5.25}}));
  EXPECT_EQ(log.booms[1], (Boom{{3, 0}, {0, 0}, {0, -3}}));
  EXPECT_TRUE(log.fixes[0].has_sections);
  EXPECT_EQ(log.fixes[0].sections, SectionStates("101"));
  EXPECT_EQ(log.fixes[0].work, WorkState::kOn);
  // The leftmost is the lowest bit.
  EXPECT_EQ(log.fixes[1].sections, SectionStates("110"));
  EXPECT_EQ(log.fixes[2].boom, -1);
  EXPECT_FALSE(log.fixes[2].has_sections);
}

TEST(CsvLog, OneWidthIsSharedByItsSections) {
  const WorkLog log = csv("lon,lat,width_m,sections\n10,50,12,0001\n");
  EXPECT_EQ(log.booms[0], (Boom{{6, 3}, {3, 0}, {0, -3}, {-3, -6}}));
  EXPECT_EQ(log.fixes[0].sections, SectionStates("1000"));
}

TEST(CsvLog, SectionsFromTheRight) {
  const WorkLog log = csv("lon,lat,width_mm,sections\n10,50,1000|2000,10\n", "sections_from_right=sections");
  EXPECT_EQ(log.fixes[0].sections, SectionStates("10"));  // the second from the left
}

TEST(CsvLog, SectionsWithoutWidthsAreOne) {
  const WorkLog log = csv("lon,lat,sections\n10,50,0100\n10,50,0000\n10,50,----\n");
  EXPECT_FALSE(log.fixes[0].has_sections);
  EXPECT_EQ(log.fixes[0].work, WorkState::kOn);
  EXPECT_EQ(log.fixes[1].work, WorkState::kOff);
  EXPECT_EQ(log.fixes[2].work, WorkState::kUnknown);
  EXPECT_TRUE(notes_mention(log, "not how wide"));
}

TEST(CsvLog, AWidthOfNoneWorksNothing) {
  const WorkLog log = csv("lon,lat,width_m,work\n10,50,0,1\n10,50,-3,1\n10,50,9999,1\n");
  ASSERT_EQ(log.fixes[0].boom, 0);
  EXPECT_EQ(log.booms[0], (Boom{{0, 0}}));
  EXPECT_EQ(log.fixes[1].boom, -1);
  EXPECT_EQ(log.fixes[2].boom, -1);
  EXPECT_TRUE(notes_mention(log, "2 rows: 'width_m'"));
}

TEST(CsvLog, WorkStates) {
  const WorkLog log =
      csv("lon,lat,Work State\n10,50,1\n10,50,0\n10,50,true\n10,50,OFF\n10,50,\n10,50,775029566\n");
  const WorkState expected[] = {WorkState::kOn,  WorkState::kOff,     WorkState::kOn,
                                WorkState::kOff, WorkState::kUnknown, WorkState::kUnknown};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(log.fixes[i].work, expected[i]) << i;
  EXPECT_TRUE(notes_mention(log, "1 rows: 'Work State'"));
}

TEST(CsvLog, ACourseIsAHeadingOnlyWhereTheMachineMoves) {
  const WorkLog log = csv("lon,lat,course,speed_kmh\n10,50,90,1.7\n10,50,90,1.9\n10,50,90,\n");
  EXPECT_TRUE(std::isnan(log.fixes[0].heading.degrees()));
  EXPECT_NEAR(log.fixes[1].heading.degrees(), 90, 1e-9);
  EXPECT_TRUE(std::isnan(log.fixes[2].heading.degrees()));
  EXPECT_NEAR(csv("lon,lat,heading,speed\n10,50,90,0\n").fixes[0].heading.degrees(), 90, 1e-9);
}

TEST(CsvLog, UnitsAreMachinesSectionsAndPasses) {
  const WorkLog log = csv("lon,lat,machine,section_id\n10,50,A,1\n10,50,A,2\n10,50,B,1\n10,50,A,1\n");
  EXPECT_EQ(log.fixes[0].unit, log.fixes[3].unit);
  EXPECT_NE(log.fixes[0].unit, log.fixes[1].unit);
  EXPECT_NE(log.fixes[0].unit, log.fixes[2].unit);
  EXPECT_NE(log.fixes[1].unit, log.fixes[2].unit);
}

// Thirty steps of 3 m to the north with the distance written in feet.
TEST(CsvLog, AWidthWithoutUnitIsInTheUnitOfTheDistances) {
  std::string feet = "x,y,swath_raw,dist_raw\n", metres = feet, none = "x,y,swath_raw\n";
  for (int i = 0; i < 30; ++i) {
    const std::string place = "1000," + std::to_string(3 * i);
    feet += place + ",20," + std::to_string(3 / 0.3048) + "\n";
    metres += place + ",20,3\n";
    none += place + ",20\n";
  }
  EXPECT_NEAR(csv(feet).booms[0][0].left_m, 10 * 0.3048, 1e-9);
  EXPECT_NEAR(csv(metres).booms[0][0].left_m, 10, 1e-9);
  const WorkLog assumed = csv(none);
  EXPECT_NEAR(assumed.booms[0][0].left_m, 10, 1e-9);
  EXPECT_TRUE(notes_mention(assumed, "taken as metres"));
  // Who names the unit is believed.
  EXPECT_NEAR(csv(feet, "width_in=swath_raw").booms[0][0].left_m, 10 * 0.0254, 1e-9);
}

TEST(CsvLog, LineByLine) {
  CsvLog live("", "'stdin'");
  EXPECT_FALSE(live.add("time,lon,lat"));
  EXPECT_FALSE(live.add("# a comment"));
  const auto fix = live.add("7,10.5,52.25");
  ASSERT_TRUE(fix);
  EXPECT_EQ(fix->record, 3U);
  EXPECT_DOUBLE_EQ(fix->time_s, 7);
  EXPECT_FALSE(live.add("8,,"));
  EXPECT_EQ(live.rows()->skipped().count, 1U);
}

TEST(MostFixes, OneMoreIsRefusedWithTheFigure) {
  EXPECT_NO_THROW(require_room_for_fix(2, "'a.csv'", 3));
  try {
    require_room_for_fix(3, "'a.csv'", 3);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_STREQ(error.what(), "'a.csv' holds more than 3 fixes; split it, such as by the day");
  }
}

}  // namespace tramline::io::csv_log_test
