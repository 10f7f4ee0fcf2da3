#pragma once
// The recent work of runs: land that a run may work again without repeating.

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "tramline/coverage/tiles/convex_piece.h"

namespace tramline::coverage {

/// Distance of travel for which a run's pieces are kept; no machine is wider.
inline constexpr double kLongestReach_m = 100;

/// The recent pieces of every run. When more than a quarter of a million pieces are kept in total, the runs
/// not extended for longest are forgotten: they ended long ago.
class RecentSwaths {
 public:
  /// Preconditions: three or four sides; travel_m does not decrease within a run.
  void add(int run, double travel_m, const ConvexPiece& piece);

  /// The parts of the piece that no piece of the run covers whose travel is `since_m` or more; no two of
  /// them overlap. O(pieces since then), and O(sides) for each that the piece meets.
  std::vector<ConvexPiece> outside(const ConvexPiece& piece, int run, double since_m) const;

 private:
  struct Worked {
    std::array<GridPoint, 4> corners;
    double travel_m = 0;
    std::uint8_t count = 0;
  };
  /// An octagon: bounds of x, y, x + y and x − y.
  struct Octagon {
    std::array<std::int64_t, 4> least;
    std::array<std::int64_t, 4> most;

    explicit Octagon(GridPoint p);
    void extend(GridPoint p);
    bool apart(const Octagon& other) const;
  };
  static constexpr std::size_t kBlock = 8;
  struct Trail {
    std::vector<Worked> pieces;   ///< by travel
    std::vector<Octagon> blocks;  ///< round kBlock pieces each
    std::size_t first = 0;        ///< pieces before it are forgotten
    std::uint64_t used = 0;       ///< time of last use
  };
  static bool apart(const ConvexPiece& piece, const Worked& worked, std::size_t& apart_by);
  static void forget_before(Trail& trail, double travel_m);
  void forget_oldest(int but);

  std::unordered_map<int, Trail> trails_;
  std::size_t pieces_ = 0;
  std::uint64_t uses_ = 0;
};

}  // namespace tramline::coverage
