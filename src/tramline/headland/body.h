#pragma once
// The body: the land that tracks have to cover.

#include "tramline/model/field.h"

namespace tramline {

/// The shapes of all obstacles of one kind.
Region obstacle_shapes(const Field& field, ObstacleKind kind);

/// Field minus obstacles, passable ones included (no headlands are kept yet), on the precision grid.
Region body_of(const Field& field);

}  // namespace tramline
