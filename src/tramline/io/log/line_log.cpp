#include "tramline/io/log/line_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/fixes/boom_list.h"
#include "tramline/io/fixes/places.h"
#include "tramline/io/log/log_format.h"
#include "tramline/io/log/settle_positions.h"

namespace tramline::io {
namespace {

bool wider_than_a_log(const Box& box) {
  return !box.empty() && (box.max_x - box.min_x > kWidestLog_deg || box.max_y - box.min_y > kWidestLog_deg);
}

}  // namespace

/// "$GPGGA," or the like, also behind a time stamp of whoever wrote the line down.
bool has_sentence(std::string_view text) {
  for (std::size_t at = text.find('$'); at != std::string_view::npos; at = text.find('$', at + 1)) {
    const std::string_view address = text.substr(at + 1, 6);
    const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    if (address.size() == 6 && address[5] == ',' &&
        std::all_of(address.begin(), address.begin() + 5, is_capital))
      return true;
  }
  return false;
}
LineLog::LineLog(LogOptions options, std::string place)
    : options_(std::move(options)), place_(std::move(place)) {
  if (!options_.crs.empty()) crs_.emplace(options_.crs);
}

/// NMEA as soon as there is a sentence; a table as soon as there is a header with positions. What comes
/// before, such as the end of a sentence whose beginning was missed, may be neither.
void LineLog::recognise(std::string_view line, std::vector<Fix>& out) {
  held_.emplace_back(line);
  held_bytes_ += line.size() + 1;
  if (has_sentence(line)) {
    kind_ = Kind::kNmea;
    nmea_.emplace();
  } else {
    CsvLog table(options_.columns, place_);
    try {
      for (const std::string& held : held_) table.add(held);
    } catch (const Error&) {
      if (held_bytes_ > kFirstBytes) throw;
    }
    if (table.rows() == nullptr) return;
    kind_ = Kind::kCsv;
    csv_.emplace(std::move(table));
    held_.clear();
  }
  if (kind_ == Kind::kNmea && !(options_.columns.empty() && options_.crs.empty()))
    throw bad_input(fmt::format("{} is NMEA: leave out --columns and --log-crs", place_));
  positions_ = named_positions();
  for (const std::string& held : std::exchange(held_, {}))
    for (const Fix& fix : add_known(held)) out.push_back(fix);
}

Positions LineLog::named_positions() const {
  if (kind_ == Kind::kNmea) return Positions::kLonLat;
  if (crs_) return crs_->plain() ? Positions::kLocal : Positions::kLonLat;
  return csv_->rows()->position_names() == PositionNames::kMetres ? Positions::kLocal : Positions::kLonLat;
}

std::vector<Fix> LineLog::add(std::string_view line) {
  ++lines_;
  if (kind_ != Kind::kOpen) return add_known(line);
  std::vector<Fix> out;
  recognise(line, out);
  return out;
}

std::vector<Fix> LineLog::add_known(std::string_view line) {
  std::optional<Fix> fix = kind_ == Kind::kNmea ? nmea_->add(line) : csv_->add(line);
  if (unstated_ && states()->first_record() != 0) urgent_ = true;
  if (!fix) return {};
  if (kind_ == Kind::kCsv && std::isfinite(csv_->rows()->last_distance()))
    distances_.push_back({fix->record, csv_->rows()->last_distance()});
  fix = taken(*fix);
  return fix ? std::vector<Fix>{*fix} : std::vector<Fix>{};
}

std::vector<Fix> LineLog::finish() {
  if (kind_ != Kind::kNmea) return {};
  std::optional<Fix> fix = nmea_->finish();
  if (fix) fix = taken(*fix);
  return fix ? std::vector<Fix>{*fix} : std::vector<Fix>{};
}

void LineLog::renew_booms() {
  const std::vector<Boom>& read = kind_ == Kind::kNmea ? nmea_->booms() : csv_->rows()->booms();
  for (std::size_t i = booms_.size(); i < read.size(); ++i) {
    booms_.push_back(read[i]);
    for (Section& section : booms_.back())
      section = {section.left_m * width_unit_m_, section.right_m * width_unit_m_};
  }
}

/// What comes out of the reader, as the log so far has it.
std::optional<Fix> LineLog::taken(Fix fix) {
  raw_.push_back(fix);
  renew_booms();
  if (kind_ == Kind::kNmea) {
    if (nmea_->midnight_s())
      fix.time_s += *nmea_->midnight_s();
    else
      undated_ = true;
    if (undated_ && nmea_->midnight_s()) urgent_ = true;
  } else {
    doubtful_ = doubtful_ || csv_->rows()->width_unit_open();
  }
  if (!own_columns().work) {
    const std::size_t first = states()->first_record();
    unstated_ = unstated_ || first == 0;
    // As work_before(): of an epoch that was still open when the first line on work came.
    if (fix.record < first && fix.work == WorkState::kUnknown && !fix.has_sections) fix.work = WorkState::kOn;
  }
  if (positions_ == Positions::kLocal) {
    doubtful_ = doubtful_ || decided_;
    return fix;
  }
  if (crs_ && !(crs_->in_degrees() && crs_->definition() == "EPSG:4326")) {
    const std::optional<Point> lonlat = crs_->to_lonlat(fix.position);
    if (!lonlat) {
      impossible_.add(fix.record,
                      fmt::format("{}, {} is no place in {}", fix.position.x, fix.position.y, crs_->name()));
      return std::nullopt;
    }
    fix.position = *lonlat;
  }
  if (std::string fault = fault_of_lonlat(fix.position); !fault.empty()) {
    impossible_.add(fix.record, std::move(fault));
    doubtful_ = doubtful_ || (kind_ == Kind::kCsv && !crs_);
    return std::nullopt;
  }
  box_.extend(fix.position);
  doubtful_ = doubtful_ || wider_than_a_log(box_);
  return fix;
}

const StateLines* LineLog::states() const {
  return kind_ == Kind::kNmea ? &nmea_->states() : &csv_->states();
}

OwnColumns LineLog::own_columns() const { return kind_ == Kind::kCsv ? csv_->own_columns() : OwnColumns{}; }

WorkLog LineLog::settle() {
  doubtful_ = urgent_ = false;  // until the next fix
  if (raw_.empty()) return head();
  undated_ = kind_ == Kind::kNmea && !nmea_->midnight_s();
  unstated_ = !own_columns().work && states()->first_record() == 0;
  WorkLog out;
  try {
    out = kind_ == Kind::kNmea ? work_log_of(*nmea_, raw_)
                               : work_log_of(*csv_, raw_, distances_, options_.crs, place_, &width_unit_m_);
  } catch (const Error&) {
    // No position is possible so far.
    return head();
  }
  const auto read_notes = static_cast<std::ptrdiff_t>(kind_ == Kind::kCsv ? csv_->rows()->notes().size() : 0);
  whole_notes_.assign(out.notes.begin() + read_notes, out.notes.end());
  if (std::string note = note_on_wide(out.booms); !note.empty()) out.notes.push_back(std::move(note));
  decided_ = out.positions != named_positions();
  positions_ = out.positions;
  booms_ = out.booms;
  impossible_ = {};
  const SkippedRecords read = head().skipped;
  impossible_.count = out.skipped.count - read.count;
  const auto first = static_cast<std::ptrdiff_t>(read.listed.size());
  if (std::ssize(out.skipped.listed) > first)
    impossible_.listed.assign(out.skipped.listed.begin() + first, out.skipped.listed.end());
  // What is far from these is looked at again; strays that were left out are not.
  box_ = {};
  if (positions_ == Positions::kLonLat)
    for (const Fix& fix : out.fixes) box_.extend(fix.position);
  return out;
}

WorkLog LineLog::head() const {
  WorkLog out;
  out.positions = positions_;
  if (kind_ == Kind::kNmea) {
    out.clock = !nmea_->has_times() ? Clock::kNone : nmea_->midnight_s() ? Clock::kUtc : Clock::kOfDay;
    out.skipped = nmea_->skipped();
  } else if (kind_ == Kind::kCsv) {
    out.clock = csv_->rows()->clock();
    out.skipped = csv_->skipped();
    out.notes = csv_->rows()->notes();
  }
  out.skipped.add(impossible_);
  out.notes.insert(out.notes.end(), whole_notes_.begin(), whole_notes_.end());
  if (std::string note = note_on_wide(booms_); !note.empty()) out.notes.push_back(std::move(note));
  return out;
}

}  // namespace tramline::io
