// Field folders against the plans that they were written of: for the long test of curated fields. A second
// reader and our own find outlines and lines within 2 mm over 2 km, and as much more where a field is larger.
// Usage: field_folder_check FOLDER PLAN [FOLDER PLAN]…   The folders have all lines (--lines all), and the
// usual tolerance. It prints what is wrong and the largest deviation, and ends with 1 where anything is
// wrong.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include "io/agopengps/plain_reader.h"
#include "tramline/geodesy/field_projection.h"
#include "tramline/geometry/path/path.h"
#include "tramline/io/land/read_fields.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/model/track.h"

namespace {

using tramline::FrameProjection;
using tramline::Plan;
using tramline::Point;
using tramline::RawDataset;
using tramline::Ring;
using tramline::testing_agopengps::FieldFiles;
using tramline::testing_agopengps::Place;

constexpr double kTolerance_m = 0.02;  // of the curves in the folder

struct Deviations {
  double outlines_m = 0, lines_m = 0;
  std::size_t points = 0, lines = 0;
  int faults = 0;
};

class Comparison {
 public:
  Comparison(std::string folder, const Plan& plan, Deviations& out)
      : folder_(std::move(folder)), plan_(plan), projection_(plan.field.frame), out_(out) {
    double farthest_m = 1000;  // from the origin, of a field of 2 km
    for (const Point corner : plan.field.outer)
      farthest_m = std::max(farthest_m, std::hypot(corner.x, corner.y));
    most_m_ = 0.002 * farthest_m / 1000;
  }

  void compare() {
    const FieldFiles files = tramline::testing_agopengps::read_plainly(folder_);
    if (files.boundaries.size() != 1 + plan_.field.obstacles.size()) return say("has other boundaries");
    ring(local(files.boundaries[0].places), plan_.field.outer);
    for (std::size_t i = 0; i < plan_.field.obstacles.size(); ++i)
      ring(local(files.boundaries[i + 1].places), plan_.field.obstacles[i].shape.outer);
    if (files.tracks.size() != plan_.pieces.size() + plan_.headland.passes.size())
      return say("has other tracks");
    for (std::size_t i = 0; i < files.tracks.size(); ++i) line(files.tracks[i], i);
    our_reader(files);
  }

 private:
  void say(const std::string& what) {
    std::printf("%s %s\n", folder_.c_str(), what.c_str());
    ++out_.faults;
  }

  Point local(const Place& place) const {
    return projection_.from_lonlat({place.lon_deg, place.lat_deg}).value();
  }
  std::vector<Point> local(const std::vector<Place>& places) const {
    std::vector<Point> out;
    for (const Place& place : places) out.push_back(local(place));
    return out;
  }

  void near(Point read, Point wanted) {
    const double off_m = distance(read, wanted);
    out_.outlines_m = std::max(out_.outlines_m, off_m);
    ++out_.points;
    if (!(off_m <= most_m_)) say("is off by " + std::to_string(off_m) + " m");
  }

  /// The same corners in the same order, or in the opposite one.
  void ring(const std::vector<Point>& read, Ring wanted) {
    if (read.size() != wanted.size()) return say("has a ring of other corners");
    if ((tramline::signed_area(read) < 0) != (tramline::signed_area(wanted) < 0)) wanted = reversed(wanted);
    const auto first = std::min_element(wanted.begin(), wanted.end(), [&](Point a, Point b) {
      return distance(a, read.front()) < distance(b, read.front());
    });
    std::rotate(wanted.begin(), first, wanted.end());
    for (std::size_t i = 0; i < read.size(); ++i) near(read[i], wanted[i]);
  }

  void line(const tramline::testing_agopengps::TrackLine& track, std::size_t i) {
    const bool piece = i < plan_.pieces.size();
    const std::vector<Point> way =
        chords(piece ? centre_line(plan_.pieces[i]) : plan_.headland.passes[i - plan_.pieces.size()].path);
    near(local(track.a), way.front());
    near(local(track.b), way.back());
    ++out_.lines;
    for (const Place& place : track.places) {
      double off_m = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k + 1 < way.size(); ++k)
        off_m = std::min(off_m, distance_to_segment(local(place), way[k], way[k + 1]));
      out_.lines_m = std::max(out_.lines_m, off_m);
      if (!(off_m <= kTolerance_m + most_m_))
        return say(track.name + " is off by " + std::to_string(off_m) + " m");
    }
  }

  /// Our own reader against the second one.
  void our_reader(const FieldFiles& files) {
    tramline::io::VectorQuery query;
    query.file = folder_;
    const RawDataset fields = tramline::io::read_fields(query);
    const auto& rings = fields.layers.at(0).features.at(0).polygons.at(0).rings;
    const std::size_t skipped = fields.skipped.size();  // those that are driven through
    if (rings.size() + skipped != files.boundaries.size()) return say("is read with other boundaries");
    for (std::size_t i = 0; i < rings[0].points.size(); ++i)
      near(projection_.from_lonlat(rings[0].points[i]).value(), local(files.boundaries[0].places.at(i)));
    query.all_layers = true;
    const RawDataset guides = tramline::io::read_guides(query);
    const auto& features = guides.layers.at(0).features;
    if (features.size() != files.tracks.size()) return say("is read with other lines");
    for (std::size_t i = 0; i < features.size(); ++i) {
      near(projection_.from_lonlat(features[i].lines.at(0).front()).value(), local(files.tracks[i].a));
      near(projection_.from_lonlat(features[i].lines[0].back()).value(), local(files.tracks[i].b));
    }
  }

  std::string folder_;
  const Plan& plan_;
  FrameProjection projection_;
  Deviations& out_;
  double most_m_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  Deviations all;
  try {
    for (int i = 1; i + 1 < argc; i += 2)
      Comparison(argv[i], tramline::io::read_plan(argv[i + 1]), all).compare();
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    ++all.faults;
  }
  std::printf(
      "AgOpenGPS: %d folders, %zu lines, %zu points off by %.4f m at most, curves by %.4f m, %d faults\n",
      (argc - 1) / 2, all.lines, all.points, all.outlines_m, all.lines_m, all.faults);
  return all.faults == 0 && all.points > 0 ? 0 : 1;
}
