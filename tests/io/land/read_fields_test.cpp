// Fields are chosen alike in task sets, in field folders and in vector files.

#include "tramline/io/land/read_fields.h"

#include <gtest/gtest.h>

#include "io/land/small_files.h"
#include "support/refusals.h"

namespace tramline::io::read_fields_test {

using testing_land::ring;
using testing_land::task_set;
using testing_support::mentions;
using testing_support::refusal_of;

const std::vector<Point> kWest = {{10, 52}, {10.01, 52}, {10.01, 52.01}, {10, 52.01}};
const std::vector<Point> kEast = {{10.02, 52}, {10.03, 52}, {10.03, 52.01}, {10.02, 52.01}};
const std::vector<Point> kPond = {{10.024, 52.004}, {10.026, 52.004}, {10.026, 52.006}};

class ReadFields : public testing_land::LandFiles {
 protected:
  VectorQuery query_of_set(const std::string& attributes = "") const {
    const auto field = [&](const std::string& id, const std::vector<Point>& points) {
      return "<PFD A=\"" + id + "\" " + attributes + "><PLN A=\"1\">" + ring("1", points) +
             "</PLN><PLN A=\"6\">" + ring("1", kPond) + "</PLN></PFD>";
    };
    write("TASKDATA.XML", task_set(field("PFD1", kWest) + field("PFD2", kEast)));
    VectorQuery out;
    out.file = path("");
    return out;
  }
  static std::vector<std::string> ids(const VectorQuery& query) {
    std::vector<std::string> out;
    const RawDataset read = read_fields(query);
    for (const RawFeature& feature : read.layers.at(0).features) out.push_back(feature.id);
    return out;
  }
};

TEST_F(ReadFields, PartfieldsAreChosenLikeFeaturesOfOtherFiles) {
  VectorQuery query = query_of_set();
  EXPECT_EQ(ids(query).size(), 2U);
  query.limit = 1;
  EXPECT_EQ(ids(query).size(), 1U);
  EXPECT_EQ(read_fields(query).layers.at(0).matching, 2);
  query.where = "id = 'PFD2'";
  ASSERT_EQ(ids(query).size(), 1U);
  EXPECT_EQ(read_fields(query).layers.at(0).features[0].fid, 2);
  query.layer = "obstacles";
  EXPECT_EQ(read_fields(query).layers.at(0).features.at(0).polygons[0].rings[0].points, kPond);
  query.layer = "roads";
  EXPECT_TRUE(mentions(refusal_of([&] { read_fields(query); }), "partfields, and obstacles"));
  query.layer_is_hint = true;
  EXPECT_EQ(read_fields(query).layers.at(0).name, "partfields");
  query.where = "id = 'PFD3'";
  EXPECT_REFUSED(read_fields(query));
  query.where = "area > 3";
  EXPECT_REFUSED(read_fields(query));
  query.where.clear();
  query.fid = 1;
  EXPECT_EQ(ids(query), (std::vector<std::string>{"PFD1"}));
  query.fid = 3;
  EXPECT_REFUSED(read_fields(query));
  query.fid.reset();
  query.all_layers = true;
  EXPECT_EQ(read_fields(query).layers.size(), 2U);
}

TEST_F(ReadFields, PartfieldsAreChosenByTheNameThatATerminalShows) {
  VectorQuery query = query_of_set(R"(B="7" C="O'Brien's")");
  query.where = "designator = 'O''Brien''s'";
  EXPECT_EQ(ids(query), (std::vector<std::string>{"PFD1", "PFD2"})) << "names may repeat";
  query.where = "code='7'";
  EXPECT_EQ(ids(query).size(), 2U);
  query.where = "designator = 'O'Brien's'";
  EXPECT_TRUE(mentions(refusal_of([&] { read_fields(query); }), "not understood"));
  query.where = "designator = 'Mill'";
  EXPECT_TRUE(mentions(refusal_of([&] { read_fields(query); }), "no partfield"));
}

TEST_F(ReadFields, AFieldFolderHasOneLayer) {
  VectorQuery query;
  query.file = write_folder("Mill", "");
  EXPECT_EQ(ids(query), (std::vector<std::string>{"Mill"}));
  query.layer = "fields";
  EXPECT_EQ(ids(query), (std::vector<std::string>{"Mill"}));
  query.layer = "partfields";
  const std::string sentence = refusal_of([&] { read_fields(query); });
  EXPECT_TRUE(mentions(sentence, "no layer 'partfields'; a field folder of AgOpenGPS has fields"))
      << sentence;
  query.layer_is_hint = true;
  EXPECT_EQ(ids(query), (std::vector<std::string>{"Mill"}));
  query.layer.clear();
  query.where = "id = 'Pond'";
  EXPECT_TRUE(mentions(refusal_of([&] { read_fields(query); }), "no field of"));
}

TEST_F(ReadFields, OtherFilesAreReadAsTheyAre) {
  VectorQuery query;
  query.file =
      write("field.geojson", R"({"type":"Polygon","coordinates":[[[10,52],[11,52],[11,53],[10,52]]]})");
  EXPECT_EQ(read_fields(query).driver, "GeoJSON");
}

}  // namespace tramline::io::read_fields_test
