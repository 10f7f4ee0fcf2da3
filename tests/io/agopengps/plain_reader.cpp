#include "io/agopengps/plain_reader.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace tramline::testing_agopengps {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::ifstream opened(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path.string());
  return file;
}

std::string line_of(std::ifstream& file) {
  std::string line;
  if (!std::getline(file, line)) throw std::runtime_error("the file ends");
  while (!line.empty() && (line.back() == '\r' || line.back() == '\n')) line.pop_back();
  return line;
}

void expect(std::ifstream& file, const char* wanted) {
  const std::string line = line_of(file);
  if (line != wanted) throw std::runtime_error("'" + line + "' instead of '" + wanted + "'");
}

class Start {
 public:
  Start(double lat_deg, double lon_deg) : lat_(lat_deg), lon_(lon_deg) {}

  /// "easting,northing" or "easting,northing,heading", three and five decimals.
  Place place_in(const std::string& line) const {
    double east = 0, north = 0, heading = 0;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf", &east, &north, &heading) < 2) throw std::runtime_error(line);
    const double at_start = lat_ * kPi / 180;
    const double per_lat = 111132.92 - 559.82 * std::cos(2.0 * at_start) + 1.175 * std::cos(4.0 * at_start) -
                           0.0023 * std::cos(6.0 * at_start);
    Place out;
    out.lat_deg = lat_ + north / per_lat;
    const double there = out.lat_deg * kPi / 180;
    const double per_lon =
        111412.84 * std::cos(there) - 93.5 * std::cos(3.0 * there) + 0.118 * std::cos(5.0 * there);
    out.lon_deg = lon_ + east / per_lon;
    out.heading_rad = heading;
    return out;
  }

  std::vector<Place> places_in(std::ifstream& file) const {
    std::vector<Place> out(std::stoul(line_of(file)));
    for (Place& place : out) place = place_in(line_of(file));
    return out;
  }

 private:
  double lat_, lon_;
};

}  // namespace

FieldFiles read_plainly(const std::filesystem::path& folder) {
  FieldFiles out;
  std::ifstream field = opened(folder / "Field.txt");
  line_of(field);  // date
  expect(field, "$FieldDir");
  out.name = line_of(field);
  for (const char* wanted : {"$Offsets", "0,0", "Convergence", "0", "StartFix"}) expect(field, wanted);
  double lat = 0, lon = 0;
  if (std::sscanf(line_of(field).c_str(), "%lf,%lf", &lat, &lon) != 2) throw std::runtime_error("StartFix");
  const Start start(lat, lon);

  std::ifstream boundary = opened(folder / "Boundary.txt");
  expect(boundary, "$Boundary");
  while (boundary.peek() != EOF) {
    Boundary ring;
    const std::string word = line_of(boundary);
    if (word != "True" && word != "False") throw std::runtime_error(word);
    ring.driven_through = word == "True";
    ring.places = start.places_in(boundary);
    out.boundaries.push_back(ring);
  }
  std::ifstream headland = opened(folder / "Headland.txt");
  expect(headland, "$Headland");
  while (headland.peek() != EOF) out.headlands.push_back(start.places_in(headland));

  std::ifstream tracks = opened(folder / "TrackLines.txt");
  expect(tracks, "$TrackLines");
  while (tracks.peek() != EOF) {
    TrackLine track;
    track.name = line_of(tracks);
    track.heading_rad = std::stod(line_of(tracks));
    track.a = start.place_in(line_of(tracks));
    track.b = start.place_in(line_of(tracks));
    expect(tracks, "0");  // nudge
    track.mode = std::stoi(line_of(tracks));
    expect(tracks, "True");
    track.places = start.places_in(tracks);
    out.tracks.push_back(track);
  }
  std::ifstream sections = opened(folder / "Sections.txt");
  while (sections.peek() != EOF) {
    const std::size_t count = std::stoul(line_of(sections));
    int red = 0, green = 0, blue = 0;
    if (std::sscanf(line_of(sections).c_str(), "%d,%d,%d", &red, &green, &blue) != 3)
      throw std::runtime_error("colour");
    Patch& patch = out.patches.emplace_back();
    for (std::size_t i = 1; i < count; ++i) patch.places.push_back(start.place_in(line_of(sections)));
    if (patch.places.size() < 4 || patch.places.size() % 2 != 0) throw std::runtime_error("pairs");
  }
  return out;
}

}  // namespace tramline::testing_agopengps
