#pragma once
// Text tables of fixes: CSV and similar formats.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tramline/io/fixes/lines.h"
#include "tramline/io/log/fix_rows.h"
#include "tramline/io/log/state_lines.h"
#include "tramline/io/log/width_unit.h"

namespace tramline::io {

/// Makes fixes of the lines of a table as they come: the header first, then one row after the other.
///
/// The separator is the commonest of comma, semicolon and tab in the header, or the one given by a line
/// "sep=;" before it; with semicolons and tabs a comma within a number is a decimal comma. Fields may be
/// quoted, also over line ends. Empty lines, comments (#, % or //) and repeated headers are ignored, and so
/// are a byte order mark and carriage returns. Lines on work (state_lines.h) apply where the table has no
/// column for it.
class CsvLog {
 public:
  /// `columns`: LogOptions::columns. `place`: for messages, "'log.csv'".
  CsvLog(std::string columns, std::string place);

  /// The fix of this line; nullopt for the header, comments, and rows without a usable position, which are
  /// put into skipped(). Fix::record is the number of the line. Positions are not validated: see
  /// settle_positions(). Throws bad_input for a header without the columns that are needed. O(line).
  std::optional<Fix> add(std::string_view line);

  /// Null before the header.
  const FixRows* rows() const { return rows_ ? &*rows_ : nullptr; }
  const StateLines& states() const { return states_; }
  /// Columns on work and width; none before the header.
  OwnColumns own_columns() const;
  SkippedRecords skipped() const;
  /// Whether a quoted field is still open.
  bool in_quotes() const { return !open_row_.empty(); }

 private:
  void read_header(std::string_view line);
  std::optional<Fix> row(std::string_view line, std::size_t record);

  std::string columns_, place_;
  char separator_ = 0;
  std::optional<FixRows> rows_;
  std::size_t line_ = 0, open_line_ = 0;
  std::string header_, open_row_;
  StateLines states_;
  SkippedRecords bad_states_;
  std::vector<std::string_view> cells_;
  std::vector<std::string> quoted_cells_;
};

/// The log of a table whose rows have all been read. Precondition: a header. Throws bad_input like
/// settle_positions(). `width_unit_m` receives the factor by which widths were multiplied.
WorkLog work_log_of(const CsvLog& csv, std::vector<Fix> fixes, std::span<const RecordedDistance> distances,
                    const std::string& crs, const std::string& place, double* width_unit_m = nullptr);

/// Reads a whole table. `place`: for messages. Throws bad_input like CsvLog and settle_positions(), and for a
/// table without a usable row. O(size).
WorkLog read_csv_log(Lines& lines, const std::string& columns, const std::string& crs,
                     const std::string& place);

}  // namespace tramline::io
