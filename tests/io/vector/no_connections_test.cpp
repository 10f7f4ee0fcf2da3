// Nothing that stands in a file opens a connection or another file; a socket of the test's own listens.

#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <memory>

#include "io/vector/files.h"
#include "tramline/geometry/error.h"
#include "tramline/io/gdal/start_gdal.h"
#include "tramline/io/log/read_log.h"
#include "tramline/io/vector/gdal_drivers.h"

namespace tramline::testing_files {
namespace {

constexpr const char* kGeoSquare =
    R"({"type": "Polygon", "coordinates": [[[9, 50], [9.01, 50], [9.01, 50.01], [9, 50.01], [9, 50]]]})";

/// Takes connections in the kernel only: whoever connects is not answered, and would wait.
class Listener {
 public:
  Listener() : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
    EXPECT_EQ(listen(socket_, 16), 0);
    socklen_t size = sizeof(address);
    getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
  }
  ~Listener() { close(socket_); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  std::string url(const std::string& path) const {
    return "http://127.0.0.1:" + std::to_string(port_) + "/" + path;
  }
  bool somebody_came() const {
    pollfd waiting{socket_, POLLIN, 0};
    return poll(&waiting, 1, 50) > 0;
  }

 private:
  int socket_;
  int port_ = 0;
};

class NoConnections : public Files {
 protected:
  /// The sentence of the refusal; empty where the file is read.
  std::string read(const std::string& file) const {
    const auto start = std::chrono::steady_clock::now();
    std::string sentence;
    try {
      read_vector(query(file));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
      sentence = error.what();
    }
    try {
      read_log(file, {});
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1)) << file;
    EXPECT_FALSE(listener_.somebody_came()) << file;
    return sentence;
  }
  void expect_refused(const std::string& file, const std::string& part) const {
    const std::string sentence = read(file);
    EXPECT_NE(sentence.find(file), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
  }
  std::string geojson(const std::string& crs) const {
    return R"({"type": "FeatureCollection", "crs": )" + crs +
           R"(, "features": [{"type": "Feature", "properties": {}, "geometry": )" + kGeoSquare + "}]}";
  }
  std::string linked() const {
    return geojson(R"({"type": "link", "properties": {"href": ")" + listener_.url("crs") +
                   R"(", "type": "ogcwkt"}})");
  }

  Listener listener_;
};

/// Else a missing connection would say nothing.
TEST_F(NoConnections, TheListenerNoticesWhoComes) {
  register_gdal_drivers();
  CPLPushErrorHandler(CPLQuietErrorHandler);
  CPLSetThreadLocalConfigOption("GDAL_HTTP_TIMEOUT", "1");
  {
    const ConnectionsAllowed typed;
    VSIStatBufL status;
    EXPECT_NE(VSIStatL(("/vsicurl/" + listener_.url("typed.geojson")).c_str(), &status), 0);
  }
  CPLPopErrorHandler();
  EXPECT_TRUE(listener_.somebody_came());
}

TEST_F(NoConnections, FoldersOfTheNetworkAreShut) {
  start_gdal();
  VSIStatBufL status;
  for (const char* folder : {"/vsicurl/", "/vsicurl_streaming/"}) {
    const std::string name = folder + listener_.url("remote.geojson");
    EXPECT_EQ(VSIFOpenL(name.c_str(), "rb"), nullptr);
    EXPECT_NE(VSIStatL(name.c_str(), &status), 0);
  }
  EXPECT_FALSE(listener_.somebody_came());
}

TEST_F(NoConnections, CrsOfGeoJsonThatIsALink) {
  expect_refused(write("link.geojson", linked()), listener_.url("crs"));
  expect_refused(write("url.geojson", geojson(R"({"type": "url", "properties": {"url": ")" +
                                              listener_.url("crs") + R"("}})")),
                 "urn:ogc:def:crs:EPSG::25832");
  expect_refused(write("name.geojson", geojson(R"({"type": "name", "properties": {"name": ")" +
                                               listener_.url("crs") + R"("}})")),
                 listener_.url("crs"));
}

TEST_F(NoConnections, CrsOfGeoJsonHiddenByEscapesOrInAGeometry) {
  std::string hidden = linked();
  hidden.replace(hidden.find("\"crs\""), 5, R"("\u0063rs")");
  expect_refused(write("hidden.geojson", hidden), listener_.url("crs"));
  std::string inner = std::string(R"({"type": "Feature", "properties": {}, "geometry": )") + kGeoSquare + "}";
  inner.insert(inner.rfind("]]]") + 3,
               R"(, "crs": {"type": "link", "properties": {"href": ")" + listener_.url("crs") + R"("}})");
  expect_refused(write("inner.geojson", inner), listener_.url("crs"));
}

/// What GDAL takes for JSON and no strict parser does: nothing is said, but nothing is fetched either.
TEST_F(NoConnections, CrsOfGeoJsonInSingleQuotes) {
  std::string loose = linked();
  loose.replace(loose.find("\"crs\""), 5, "'crs'");
  read(write("loose.geojson", loose));
}

TEST_F(NoConnections, CrsOfGeoJsonWithinAnArchive) {
  write_zip(path("sent.zip"), {{"maps/field.geojson", linked()}});
  expect_refused(path("sent.zip"), listener_.url("crs"));
}

TEST_F(NoConnections, CrsOfGeoJsonThatIsAFile) {
  const std::string wkt = write("own.prj", "");
  expect_refused(
      write("path.geojson", geojson(R"({"type": "name", "properties": {"name": ")" + wkt + R"("}})")), wkt);
}

TEST_F(NoConnections, NamesOfCrsAreReadAsEver) {
  for (const char* name :
       {"urn:ogc:def:crs:OGC:1.3:CRS84", "EPSG:4326", "http://www.opengis.net/def/crs/OGC/1.3/CRS84"})
    EXPECT_EQ(read(write("named.geojson", geojson(R"({"type": "name", "properties": {"name": ")" +
                                                  std::string(name) + R"("}})"))),
              "")
        << name;
}

TEST_F(NoConnections, Vrt) {
  const std::string vrt = R"(<OGRVRTDataSource><OGRVRTLayer name="f"><SrcDataSource>)" +
                          listener_.url("f.geojson") + "</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>";
  expect_refused(write("field.vrt", vrt), "name the file that holds them");
  expect_refused(write("field.gml", "<!-- a map -->\n" + vrt), "name the file that holds them");
}

TEST_F(NoConnections, WebFeatureServices) {
  expect_refused(
      write("wfs.xml", "<OGRWFSDataSource><URL>" + listener_.url("wfs") + "</URL></OGRWFSDataSource>"),
      "name the file that holds them");
}

std::string gml(const std::string& before, const std::string& root, const std::string& member) {
  return "<?xml version=\"1.0\"?>\n" + before +
         "<ogr:FeatureCollection xmlns:ogr=\"http://ogr.maptools.org/\" "
         "xmlns:gml=\"http://www.opengis.net/gml\" "
         "xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
         "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" " +
         root + "><gml:featureMember><ogr:f fid=\"f.1\">" + member +
         "</ogr:f></gml:featureMember></ogr:FeatureCollection>";
}

constexpr const char* kGmlSquare =
    "<ogr:g><gml:Polygon srsName=\"EPSG:4326\"><gml:outerBoundaryIs><gml:LinearRing><gml:coordinates>9,50 "
    "9.01,50 "
    "9.01,50.01 9,50.01 9,50</gml:coordinates></gml:LinearRing></gml:outerBoundaryIs></gml:Polygon></ogr:g>";

TEST_F(NoConnections, EntitiesOfGml) {
  expect_refused(
      write("entity.gml", gml("<!DOCTYPE f [<!ENTITY e SYSTEM \"" + listener_.url("entity") + "\">]>\n", "",
                              std::string(kGmlSquare) + "<ogr:n>&e;</ogr:n>")),
      "<!DOCTYPE>");
  expect_refused(
      write("dtd.gml", gml("<!DOCTYPE f SYSTEM \"" + listener_.url("dtd") + "\">\n", "", kGmlSquare)),
      "<!DOCTYPE>");
}

TEST_F(NoConnections, SchemasLinksAndCrsOfGml) {
  EXPECT_EQ(
      read(write("schema.gml",
                 gml("", "xsi:schemaLocation=\"http://ogr.maptools.org/ " + listener_.url("f.xsd") + "\"",
                     kGmlSquare))),
      "");
  read(write(
      "xlink.gml",
      gml("", "", "<ogr:g xlink:href=\"" + listener_.url("g.gml") + "#g\"/>" + std::string(kGmlSquare))));
  std::string srs = gml("", "", kGmlSquare);
  srs.replace(srs.find("EPSG:4326"), 9, listener_.url("crs"));
  read(write("srs.gml", srs));
}

TEST_F(NoConnections, LinksAndStylesOfKml) {
  const std::string place =
      "<Placemark><styleUrl>" + listener_.url("style.kml") +
      "#s</styleUrl><Polygon><outerBoundaryIs><LinearRing><coordinates>9,50 9.01,50 9.01,50.01 9,50.01 "
      "9,50</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>";
  const std::string link =
      "<NetworkLink><Link><href>" + listener_.url("more.kml") + "</href></Link></NetworkLink>";
  const auto kml = [](const std::string& inside) {
    return "<?xml version=\"1.0\"?><kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>" + inside +
           "</Document></kml>";
  };
  EXPECT_EQ(read(write("both.kml", kml(link + place))), "");
  expect_refused(write("link.kml", kml(link)), "link.kml");
}

TEST_F(NoConnections, DefinitionsInShapefilesAndGeoPackages) {
  write_layer("ESRI Shapefile", path("f.shp"), "f", 25832, {{"a", "POLYGON ((0 0, 100 0, 100 50, 0 0))"}});
  write("f.prj", listener_.url("crs"));
  read(path("f.shp"));
  write_layer("GPKG", path("f.gpkg"), "f", 25832, {{"a", "POLYGON ((0 0, 100 0, 100 50, 0 0))"}});
  {
    const GDALDatasetUniquePtr data(
        GDALDataset::Open(path("f.gpkg").c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
    ASSERT_TRUE(data);
    data->ExecuteSQL(("UPDATE gpkg_spatial_ref_sys SET definition = '" + listener_.url("crs") +
                      "', organization = 'NONE' WHERE srs_id = 25832")
                         .c_str(),
                     nullptr, nullptr);
  }
  read(path("f.gpkg"));
}

TEST_F(NoConnections, TablesOfSqliteThatReadOtherFiles) {
  write_layer("SQLite", path("f.sqlite"), "f", 4326, {{"a", "POLYGON ((9 50, 9.01 50, 9.01 50.01, 9 50))"}});
  EXPECT_EQ(read(path("f.sqlite")), "");
  {
    const GDALDatasetUniquePtr data(
        GDALDataset::Open(path("f.sqlite").c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
    ASSERT_TRUE(data);
    data->ExecuteSQL("PRAGMA writable_schema = 1", nullptr, nullptr);
    data->ExecuteSQL(
        "INSERT INTO sqlite_master (type, name, tbl_name, rootpage, sql) VALUES ('table', 'other', "
        "'other', 0, 'CREATE VIRTUAL TABLE other USING VirtualText(''/etc/passwd'', ''UTF-8'', 0)')",
        nullptr, nullptr);
  }
  expect_refused(path("f.sqlite"), "virtual table");
}

TEST_F(NoConnections, TablesOfMapInfoMadeOfOthers) {
  expect_refused(write("all.tab", "!table\n!version 300\n\nbegin_metadata\n\"\\IsSeamless\" = \"TRUE\"\n"),
                 "name the tables themselves");
}

}  // namespace
}  // namespace tramline::testing_files
