#pragma once
// Which column of a table is what.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tramline/model/work_log.h"

namespace tramline::io {

/// What a column can hold.
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
  kCounterArea,        ///< what the machine has counted so far
  kDistance,           ///< way since the last record; only tells the unit of a width that has none
  kMachine,
  kSection,
  kUnit,
  kPass,
};
inline constexpr std::size_t kColumns = static_cast<std::size_t>(LogColumn::kPass) + 1;

/// One column and its unit.
struct ColumnUse {
  std::size_t index = 0;
  double factor = 1;        ///< times this: metres, metres a second, degrees, amounts a hectare
  bool unit_named = false;  ///< by the name of the column or by the user
  AmountUnit amount = AmountUnit::kUnknown;  ///< of a rate
};

/// What the names of the position columns say about their frame.
enum class PositionNames { kDegrees, kMetres, kEither };

/// Where the positions of the rows of a table come from.
enum class PositionSource { kTable, kElsewhere };

/// The columns of a table that are used.
struct ColumnMap {
  std::array<std::optional<ColumnUse>, kColumns> uses;
  PositionNames position_names = PositionNames::kEither;

  const std::optional<ColumnUse>& operator[](LogColumn column) const {
    return uses[static_cast<std::size_t>(column)];
  }
};

/// Finds the columns by their common names (docs/logs.md): case, blanks and brackets do not matter, and where
/// several fit, the commoner name wins. `wanted`: "lon=Xcoord,lat=Ycoord,width_ft=swath" names some or all of
/// them; "width=" leaves one out. Throws bad_input, with `place` in front, for a word that is no column of a
/// log, for a wanted column that the table does not have, and, unless the positions come from elsewhere, when
/// there are none; the sentence lists the columns found.
ColumnMap map_columns(std::span<const std::string> names, const std::string& wanted, PositionSource positions,
                      const std::string& place);

}  // namespace tramline::io
