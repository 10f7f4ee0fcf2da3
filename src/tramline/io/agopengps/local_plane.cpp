#include "tramline/io/agopengps/local_plane.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace tramline::io {
namespace {

/// Of AgOpenGPS (CNMEA): metres in a degree of latitude, and of longitude.
double latitude_degree_m(double latitude_deg) {
  const double phi = latitude_deg * std::numbers::pi / 180;
  return 111132.92 - 559.82 * std::cos(2 * phi) + 1.175 * std::cos(4 * phi) - 0.0023 * std::cos(6 * phi);
}

double longitude_degree_m(double latitude_deg) {
  const double phi = latitude_deg * std::numbers::pi / 180;
  return 111412.84 * std::cos(phi) - 93.5 * std::cos(3 * phi) + 0.118 * std::cos(5 * phi);
}

}  // namespace

LocalPlane::LocalPlane(Point start_lonlat)
    : start_(start_lonlat), latitude_degree_m_(latitude_degree_m(start_lonlat.y)) {
  assert(std::abs(start_lonlat.y) <= kMostLatitude_deg);
}

Point LocalPlane::to_plane(Point lonlat) const {
  return {std::remainder(lonlat.x - start_.x, 360) * longitude_degree_m(lonlat.y),
          (lonlat.y - start_.y) * latitude_degree_m_};
}

Point LocalPlane::to_lonlat(Point metres) const {
  const double latitude = start_.y + metres.y / latitude_degree_m_;
  return {start_.x + metres.x / longitude_degree_m(latitude), latitude};
}

}  // namespace tramline::io
