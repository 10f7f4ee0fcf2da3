#pragma once
// A second reader of AgOpenGPS field folders, for the tests: written from the description of the format, it
// shares nothing with the other one.

#include <filesystem>
#include <string>
#include <vector>

namespace tramline::testing_agopengps {

struct Place {
  double lat_deg = 0, lon_deg = 0;
  double heading_rad = 0;
};

struct Boundary {
  bool driven_through = false;
  std::vector<Place> places;
};

struct TrackLine {
  std::string name;
  double heading_rad = 0;
  Place a, b;
  int mode = 0;
  std::vector<Place> places;
};

/// A strip of worked land: left and right places in turn.
struct Patch {
  std::vector<Place> places;
};

struct FieldFiles {
  std::string name;
  std::vector<Boundary> boundaries;
  std::vector<std::vector<Place>> headlands;
  std::vector<TrackLine> tracks;
  std::vector<Patch> patches;
};

/// Throws std::runtime_error where a file is not as described.
FieldFiles read_plainly(const std::filesystem::path& folder);

}  // namespace tramline::testing_agopengps
