#pragma once
// The meaning of the columns of a table.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tramline/model/work_log.h"

namespace tramline::io {

/// The possible contents of a column.
enum class LogColumn {
  kLon,
  kLat,
  kTime,
  kDate,
  kHeading,
  kCourse,  ///< over the ground: a heading only where the machine moves
  kSpeed,
  kWidth,
  kWork,
  kSections,           ///< a sign for each section from left to right: 0, 1, or - where not known
  kSectionsFromRight,  ///< the same from right to left
  kRate,               ///< applied, an amount for an area
  kCondensed,          ///< states as ISO 11783-11 condenses them (DDI 161): two bits a section
  kCounterArea,        ///< area counted by the machine so far
  kDistance,           ///< distance since the last record; used only to find the unit of a width without one
  kMachine,
  kSection,
  kUnit,
  kPass,
};
inline constexpr std::size_t kColumns = static_cast<std::size_t>(LogColumn::kPass) + 1;

/// One column and its unit.
struct ColumnUse {
  std::size_t index = 0;
  double factor = 1;        ///< factor to metres, metres per second, degrees or amounts per hectare
  bool unit_named = false;  ///< whether the name of the column or the user gives the unit
  AmountUnit amount = AmountUnit::kUnknown;  ///< of a rate
};

/// The frame of positions implied by the names of their columns.
enum class PositionNames { kDegrees, kMetres, kEither };

/// The source of the positions of a table's rows.
enum class PositionSource { kTable, kElsewhere };

/// The columns of a table that are read.
struct ColumnMap {
  std::array<std::optional<ColumnUse>, kColumns> uses;
  PositionNames position_names = PositionNames::kEither;

  const std::optional<ColumnUse>& operator[](LogColumn column) const {
    return uses[static_cast<std::size_t>(column)];
  }
};

/// Finds the columns by their common names (docs/logs.md): case, blanks and brackets do not matter, and where
/// several fit, the commoner name wins. `wanted`: "lon=Xcoord,lat=Ycoord,width_ft=swath" names some or all of
/// them; "width=" leaves one out. Throws bad_input, beginning with `place`, for a word that is not a column
/// of a log, for a wanted column that the table does not have, and, unless the positions come from elsewhere,
/// when there are none; the sentence lists the columns found.
ColumnMap map_columns(std::span<const std::string> names, const std::string& wanted, PositionSource positions,
                      const std::string& place);

}  // namespace tramline::io
