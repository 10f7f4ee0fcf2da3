#pragma once
// Names shared by the writer and the reader of files of fields.

#include "tramline/io/geopackage/file_kind.h"

namespace tramline::io {

inline constexpr FileKind kFieldFile{"field", "tramline serve"};
inline constexpr const char* kFieldFormat = "tramline field";
inline constexpr int kFieldVersion = 1;

}  // namespace tramline::io

namespace tramline::io::field_layers {

inline constexpr const char* kField = "field";
inline constexpr const char* kObstacles = "obstacles";
inline constexpr const char* kObstacle = "obstacle";
inline constexpr const char* kPassable = "passable";

}  // namespace tramline::io::field_layers
