#pragma once
// Drives up and down over a field, as texts of logs, and readers of their frames.

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "server/work/work_frame.h"
#include "tramline/coverage/tiles/tile_frame.h"
#include "tramline/geodesy/field_projection.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::server::testing_drives {

inline constexpr double kLon = 10.5, kLat = 52.3;

inline LocalFrame frame_here() {
  LocalFrame out;
  out.geodetic = true;
  out.origin_lon_deg = kLon;
  out.origin_lat_deg = kLat;
  return out;
}

/// 200 m by 150 m with a pond of 20 m by 20 m.
inline Region field_here() {
  return {{{{-100, -75}, {100, -75}, {100, 75}, {-100, 75}}, {{{0, 0}, {0, 20}, {20, 20}, {20, 0}}}}};
}

/// Places 2 m apart on lanes `apart_m` from one another, as longitude and latitude; every fifth lane is left
/// out, and every seventh overlaps the one before.
inline std::vector<Point> lanes(int fixes, double apart_m = 6) {
  const FrameProjection projection(frame_here());
  std::vector<Point> out;
  for (int i = 0; i < fixes; ++i) {
    const int lane = i / 95 % 24, along = i % 95;
    const double x = -94 + 2.0 * (lane % 2 == 0 ? along : 94 - along);
    const double shift = lane % 7 == 6 ? -2 : 0;
    const double y = -72 + apart_m * (lane + lane / 5) + shift;
    out.push_back(projection.to_lonlat({x, y}));
  }
  return out;
}

/// Without the header, which is csv_header().
inline std::string csv_line(int second_tenths, Point lonlat, double width_m) {
  return fmt::format("2026-05-06T{:02}:{:02}:{:02}.{}Z,{:.9f},{:.9f},{:g}", 8 + second_tenths / 36000,
                     second_tenths / 600 % 60, second_tenths / 10 % 60, second_tenths % 10, lonlat.x,
                     lonlat.y, width_m);
}
inline std::string csv_header() { return "time,lon,lat,width"; }

inline std::vector<std::string> csv_lines(int fixes, int tenths_apart = 10, double width_m = 6) {
  std::vector<std::string> out{csv_header()};
  const std::vector<Point> places = lanes(fixes);
  for (int i = 0; i < fixes; ++i)
    out.push_back(csv_line(i * tenths_apart, places[static_cast<std::size_t>(i)], width_m));
  return out;
}

inline std::string joined(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& line : lines) (out += line) += '\n';
  return out;
}

/// Somebody who has nothing but the events.
struct Follower {
  std::map<coverage::TileIndex, coverage::TileWork> tiles{};
  std::vector<WorkFrame> frames{};
  std::vector<std::chrono::steady_clock::time_point> when{};
  std::vector<FeedState> states{};
  bool ended = false;
  WorkFigures end{};
  std::size_t places = 0;

  void take(const WorkEvent& event) {
    if (const auto* state = std::get_if<FeedState>(&event)) states.push_back(*state);
    if (const auto* last = std::get_if<WorkEnd>(&event)) {
      ended = true;
      end = last->figures;
    }
    const auto* frame = std::get_if<WorkFrame>(&event);
    if (frame == nullptr) return;
    if (frame->changes.all) {
      tiles.clear();
      places = 0;
    }
    for (const coverage::TileWork& tile : frame->changes.tiles) tiles.insert_or_assign(tile.index, tile);
    places += frame->line.size();
    frames.push_back(*frame);
    when.push_back(std::chrono::steady_clock::now());
  }
  double covered_m2() const { return sum(&coverage::TileWork::covered); }
  double repeated_m2() const { return sum(&coverage::TileWork::repeated); }

  /// Until the end. `pause`: after every event.
  template <class Source>
  void follow(Source& source, std::chrono::milliseconds pause = std::chrono::milliseconds(0)) {
    while (!ended) {
      take(source.next(std::chrono::milliseconds(500)));
      std::this_thread::sleep_for(pause);
    }
  }

 private:
  double sum(Region coverage::TileWork::*of) const {
    double out = 0;
    for (const auto& [index, tile] : tiles) out += area(tile.*of);
    return out;
  }
};

}  // namespace tramline::server::testing_drives
