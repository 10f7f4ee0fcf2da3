#include "server/store/shape_key.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

namespace tramline::server {
namespace {

/// FNV-1a of whole numbers.
class Digest {
 public:
  void add(std::int64_t number) {
    constexpr int kBytes = 8, kBits = 8;
    for (int i = 0; i < kBytes; ++i) {
      state_ ^= static_cast<std::uint64_t>(number >> (kBits * i)) & 0xffU;
      state_ *= 0x100000001b3U;
    }
  }
  void add(const LocalFrame& frame) {
    constexpr double kPerDegree = 1e8, kPerMetre = 1000;
    add(frame.geodetic ? 1 : 0);
    add(std::llround((frame.geodetic ? frame.origin_lon_deg * kPerDegree : frame.origin_x_m * kPerMetre)));
    add(std::llround((frame.geodetic ? frame.origin_lat_deg * kPerDegree : frame.origin_y_m * kPerMetre)));
  }
  void add(const Ring& ring) {
    constexpr double kPerMetre = 1000;
    add(static_cast<std::int64_t>(ring.size()));
    for (const Point p : ring) {
      add(std::llround(p.x * kPerMetre));
      add(std::llround(p.y * kPerMetre));
    }
  }
  std::string text() const { return fmt::format("{:016x}", state_); }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325U;
};

}  // namespace

std::string shape_key(const Field& field) {
  Digest digest;
  digest.add(field.frame);
  digest.add(field.outer);
  for (const Obstacle& obstacle : field.obstacles) {
    digest.add(obstacle.kind == ObstacleKind::kPassable ? 1 : 0);
    digest.add(obstacle.shape.outer);
    for (const Ring& hole : obstacle.shape.holes) digest.add(hole);
  }
  return digest.text();
}

}  // namespace tramline::server
