#pragma once
// Converts rows of a table to fixes, one after the other, for CSV files and attributes of vector files.

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tramline/io/fixes/boom_list.h"
#include "tramline/io/fixes/counter_total.h"
#include "tramline/io/log/columns.h"
#include "tramline/io/log/time_column.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// The format of a table.
struct TableForm {
  std::string place;    ///< "'log.csv'", for messages
  std::string columns;  ///< LogOptions::columns
  PositionSource positions = PositionSource::kTable;
  bool decimal_comma = false;
};

/// Makes one fix of one row. Widths of several sections ("3000|4500|3000") stand from left to right, side by
/// side, in the middle of the machine. Positions are not validated: see settle_positions().
class FixRows {
 public:
  /// Throws bad_input like map_columns().
  FixRows(std::span<const std::string> names, TableForm form);

  /// nullopt for a row without a position, which is put into skipped(). `elsewhere`: the position of a table
  /// without columns for it. O(cells).
  std::optional<Fix> add(std::span<const std::string_view> cells, std::size_t record,
                         std::optional<Point> elsewhere = std::nullopt);

  const std::vector<Boom>& booms() const { return booms_.booms(); }
  BoomList& boom_list() { return booms_; }
  bool has(LogColumn column) const { return map_[column].has_value(); }
  const SkippedRecords& skipped() const { return skipped_; }
  Clock clock() const { return time_.clock(); }
  PositionNames position_names() const { return map_.position_names; }
  /// The distance column of the last row, in the unit of the table; NaN: none.
  double last_distance() const { return last_distance_; }
  AmountUnit rate_unit() const {
    return map_[LogColumn::kRate] ? map_[LogColumn::kRate]->amount : AmountUnit::kUnknown;
  }
  /// The counters of all machines together.
  MachineCounters counters() const;
  /// Whether the table leaves the unit of its widths open.
  bool width_unit_open() const;
  /// The assumptions made so far.
  std::vector<std::string> notes() const;

 private:
  /// Widths of one row, metres.
  using Widths = std::vector<double>;

  std::string_view cell(LogColumn column) const;
  std::optional<double> number(LogColumn column) const;
  std::optional<double> number_of(std::string_view text) const;
  std::optional<Point> position() const;
  std::optional<Widths> widths();
  void set_motion(Fix& fix) const;
  void set_work(Fix& fix);
  void set_rate(Fix& fix);
  void set_sections(Fix& fix, std::optional<Widths> widths);
  int unit_of_row();

  TableForm form_;
  ColumnMap map_;
  std::vector<std::string> names_;
  TimeColumn time_;
  BoomList booms_;
  std::map<std::string, int, std::less<>> units_;
  std::map<std::string, CounterTotal> areas_;  ///< of each machine
  SkippedRecords skipped_;
  std::span<const std::string_view> cells_;  ///< of the row being read
  double last_distance_ = std::numeric_limits<double>::quiet_NaN();
  std::size_t bad_times_ = 0, bad_work_ = 0, bad_rates_ = 0, bad_widths_ = 0, bad_sections_ = 0,
              sections_without_width_ = 0;
};

}  // namespace tramline::io
