#include "tramline/geodesy/crs.h"

#include <gtest/gtest.h>

#include <limits>

#include "tramline/geometry/error.h"

namespace tramline {
namespace {

TEST(Crs, NoneAndEmptyArePlainMetres) {
  EXPECT_TRUE(Crs().plain());
  EXPECT_TRUE(Crs("").plain());
  EXPECT_TRUE(Crs("none").plain());
  EXPECT_EQ(Crs("none").name(), "plain metres");
}

TEST(Crs, DegreesStayLongitudeFirstWhateverTheAuthoritySays) {
  const Crs crs("EPSG:4326");  // latitude first by its definition
  EXPECT_TRUE(crs.in_degrees());
  const Point lonlat = crs.to_lonlat({12.123456789, 48.5}).value();
  EXPECT_EQ(lonlat, (Point{12.123456789, 48.5}));
}

// On the central meridian of UTM zone 32 the easting is 500 000 m, at the equator the northing is 0.
TEST(Crs, UtmOriginIsNineDegreesEastOnTheEquator) {
  const Crs crs("EPSG:25832");
  EXPECT_FALSE(crs.in_degrees());
  const Point lonlat = crs.to_lonlat({500000, 0}).value();
  EXPECT_NEAR(lonlat.x, 9, 1e-12);
  EXPECT_NEAR(lonlat.y, 0, 1e-12);
  ASSERT_TRUE(crs.grid().has_value());
  EXPECT_EQ(crs.grid()->false_easting_m, 500000);
  EXPECT_NEAR(crs.grid()->central_meridian_deg, 9, 1e-12);
}

TEST(Crs, ZonePrefixedGridHasItsOwnFalseEasting) {
  const Crs crs("EPSG:4647");
  ASSERT_TRUE(crs.grid().has_value());
  EXPECT_EQ(crs.grid()->false_easting_m, 32500000);
  EXPECT_NEAR(crs.to_lonlat({32500000, 0}).value().x, 9, 1e-12);
}

TEST(Crs, ThereAndBackAgain) {
  for (const char* name : {"EPSG:25832", "EPSG:28992", "EPSG:5514", "EPSG:2056", "EPSG:3857"}) {
    const Crs crs(name);
    const Point lonlat{8.0 + 0.25, 47.5};
    const Point input = crs.from_lonlat(lonlat).value();
    const Point again = crs.to_lonlat(input).value();
    EXPECT_NEAR(again.x, lonlat.x, 1e-9) << name;
    EXPECT_NEAR(again.y, lonlat.y, 1e-9) << name;
  }
}

TEST(Crs, NationalGridsAreEastingFirstAndNorthUp) {
  const Crs crs("EPSG:2056");  // Swiss: the origin of the grid is the old observatory of Bern
  const Point bern = crs.to_lonlat({2600000, 1200000}).value();
  EXPECT_NEAR(bern.x, 7.4386, 1e-3);
  EXPECT_NEAR(bern.y, 46.9511, 1e-3);
}

TEST(Crs, DefinitionsMakeTheSameCrsAgain) {
  EXPECT_EQ(Crs("none").definition(), "none");
  EXPECT_EQ(Crs("ETRS89 / UTM zone 32N").definition(), "EPSG:25832");
  const Crs own("+proj=tmerc +lat_0=50 +lon_0=8 +k=0.9999 +x_0=1000 +ellps=GRS80 +type=crs");
  EXPECT_EQ(own.definition().substr(0, 7), "PROJCRS");
  const Crs again(own.definition());
  EXPECT_EQ(again.to_lonlat({2000, 3000}), own.to_lonlat({2000, 3000}));
}

TEST(Crs, KnowsWhatLiesFarFromItsArea) {
  EXPECT_TRUE(Crs("EPSG:25832").is_near({9, 50}));
  EXPECT_TRUE(Crs("EPSG:25832").is_near({14.5, 50})) << "a neighbouring zone may be asked for";
  EXPECT_FALSE(Crs("EPSG:2193").is_near({9, 50})) << "New Zealand";
  EXPECT_TRUE(Crs("EPSG:2193").is_near({-178, -40})) << "its area goes over 180 degrees";
  EXPECT_FALSE(Crs("EPSG:28992").is_near({5, -30}));
  EXPECT_TRUE(Crs("EPSG:3857").is_near({-170, -60}));
}

TEST(Crs, NotFiniteAndUnreachablePointsAreRefused) {
  const Crs utm("EPSG:25832");
  EXPECT_FALSE(utm.to_lonlat({std::numeric_limits<double>::quiet_NaN(), 0}).has_value());
  EXPECT_FALSE(utm.to_lonlat({500000, std::numeric_limits<double>::infinity()}).has_value());
  EXPECT_FALSE(utm.to_lonlat({1e12, 1e12}).has_value());
}

TEST(Crs, UnknownNamesAreBadInputThatSuggestsOne) {
  for (const char* name :
       {"EPSG:99999999", "nonsense", "foo" /* the end of Amersfoort */, "EPSG:5703" /* heights only */}) {
    try {
      const Crs crs{std::string(name)};
      ADD_FAILURE() << name << " was taken for a CRS";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("--crs EPSG:25832"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace tramline
