#pragma once
// The directions and widths whose maps are to be compared, as typed.

#include <optional>
#include <string>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/model/plan.h"

namespace tramline::app {

/// One of the directions that a field is mapped in.
struct MapDirection {
  enum class Kind { kGiven, kEdge, kAngle, kCurved };
  Kind kind = Kind::kGiven;   ///< kGiven: as the other options say, along a line or as the planner chooses
  Direction direction{};      ///< with kEdge and kAngle
  double edge_m = 0;          ///< with kEdge: length of the edge
  std::vector<Point> line{};  ///< with kEdge and kAngle: two points, local metres, in the direction of
                              ///< tracks; an edge has the field on its right

  friend bool operator==(const MapDirection& a, const MapDirection& b) = default;
};

struct MapDirections {
  std::vector<MapDirection> all;
  std::size_t edges_left_out = 0;  ///< directions of shorter edges, beyond kMostEdgeDirections
};

/// No more directions of edges than these are mapped, those of the longest edges.
inline constexpr std::size_t kMostEdgeDirections = 16;

/// Edges whose directions differ by no more than this are mapped once.
inline constexpr Angle kEdgesAlike = Angle::degrees(5);

/// The directions of the outer ring's edges, each that of its longest edge and farther than `merge` and
/// kEdgesAlike from those of longer ones, longest edge first; equally long ones in the order of the ring.
/// O(n²).
MapDirections edge_directions(const Field& field, Angle merge);

/// "edges,curved,0,45.5": words and degrees clockwise from north (Direction), in any order, each at most
/// once. Throws bad_input for anything else.
struct DirectionWords {
  enum class Word { kEdges, kCurved, kAngle };
  struct Item {
    Word word = Word::kEdges;
    Direction direction{};  ///< with kAngle
    friend bool operator==(const Item& a, const Item& b) = default;
  };
  std::vector<Item> items;
};
DirectionWords direction_words(const std::string& text);

/// The directions of the words on a field.
MapDirections map_directions(const DirectionWords& words, const Field& field, Angle merge);

/// "2,4,6": working widths, m, each once, in the order given. Throws bad_input.
std::vector<double> map_widths(const std::string& text);
/// The words between commas, without the spaces round them.
std::vector<std::string> words_of(const std::string& text);

/// The settings for a map in this direction. Edges and angles are anchored at the envelope unless the
/// settings say otherwise. Throws bad_input where an angle is to be anchored at a line: it has none.
PlanSettings settings_in_direction(const PlanSettings& settings, const MapDirection& direction);

}  // namespace tramline::app
