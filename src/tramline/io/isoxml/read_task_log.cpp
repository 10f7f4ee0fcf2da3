#include "tramline/io/isoxml/read_task_log.h"

#include "tramline/io/isoxml/time_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/fixes/boom_list.h"
#include "tramline/io/fixes/job_groups.h"
#include "tramline/io/fixes/most_fixes.h"
#include "tramline/io/fixes/number_text.h"
#include "tramline/io/fixes/places.h"
#include "tramline/io/isoxml/logged_counters.h"
#include "tramline/io/isoxml/logged_machine.h"
#include "tramline/io/isoxml/time_log_header.h"
#include "tramline/io/isoxml/time_log_records.h"

namespace tramline::io {
namespace {

// ISO 11783-10, PTN@D.
constexpr int kNoPosition = 0, kPositionError = 14;

std::string fault_of(const TimeLogRecord& record) {
  if (record.status == kNoPosition) return "the receiver had no position";
  if (record.status == kPositionError) return "the receiver was in error";
  return fault_of_lonlat(record.lonlat_deg);
}

std::vector<std::string> names_of(const std::vector<LogEntry>& logs) {
  std::vector<std::string> out;
  for (const LogEntry& log : logs) out.push_back(log.name);
  return out;
}

/// The logs that are meant.
std::vector<LogEntry> chosen(const TaskFiles& files, const TaskData& tasks, const std::string& wanted) {
  const std::string name = wanted.empty() ? files.only_log() : wanted;
  const auto is_named = [&](const LogEntry& log) { return lower_case(log.name) == lower_case(name); };
  if (name.empty()) {
    if (tasks.logs.empty())
      throw bad_input(fmt::format("'{}' holds no time log; export the tasks with their logs", files.path()));
    return tasks.logs;
  }
  if (const auto at = std::find_if(tasks.logs.begin(), tasks.logs.end(), is_named); at != tasks.logs.end())
    return {*at};
  // A log beside a task set that does not name it was asked for by its own name.
  if (files.read(name + ".xml") || files.read(name + ".bin")) return {{name, "", "", ""}};
  throw bad_input(
      fmt::format("'{}' has no log '{}'; found {}", files.path(), name,
                  tasks.logs.empty() ? "none" : fmt::format("{}", fmt::join(names_of(tasks.logs), ", "))));
}

/// The two files of a log.
struct LogFiles {
  std::optional<std::string> xml, bin;
};

LogFiles files_of(const TaskFiles& files, const LogEntry& entry) {
  return {files.read(entry.name + ".xml"), files.read(entry.name + ".bin")};
}

/// A log with the devices that worked.
struct DecodedLog {
  LogEntry entry;
  WorkLog log;
  std::vector<std::string> devices;
};

DecodedLog decode_bytes(std::string_view header_xml, std::string_view bytes,
                        const std::vector<DeviceElement>& elements, const std::string& place) {
  const TimeLogHeader header = read_time_log_header(header_xml, place + ", header");
  if (!header.has_position)
    throw bad_input(fmt::format("{} records no positions (its header has no element PTN)", place));
  DecodedLog out;
  WorkLog& log = out.log;
  log.clock = Clock::kUtc;
  LoggedMachine machine(header, elements);
  LoggedCounters counters(header, machine.elements());
  BoomList booms;
  TimeLogRecords records(header, bytes);
  while (const auto record = records.next()) {
    machine.update(*record);
    counters.update(*record);
    if (std::string fault = fault_of(*record); !fault.empty()) {
      log.skipped.add(record->number, std::move(fault));
      continue;
    }
    require_room_for_fix(log.fixes.size(), place);
    Fix fix;
    fix.record = record->number;
    fix.time_s = record->time_s;
    fix.position = record->lonlat_deg;
    machine.describe(fix, booms);
    log.fixes.push_back(fix);
  }
  log.booms = booms.booms();
  for (const SkippedRecord& skipped : records.skipped().listed) log.skipped.add(skipped.record, skipped.why);
  log.skipped.count += records.skipped().count - records.skipped().listed.size();
  log.rate_unit = machine.rate_unit();
  log.counters = counters.totals();
  log.notes = machine.notes();
  skip_strays(log);
  out.devices = machine.devices();
  return out;
}

DecodedLog decode(const TaskFiles& files, const LogFiles& log, const LogEntry& entry, const TaskData& tasks) {
  const std::string place = fmt::format("'{}', {}", files.path(), entry.name);
  if (!log.xml)
    throw bad_input(fmt::format("{}: the header {}.xml is missing; without it the records cannot be read",
                                place, entry.name));
  if (!log.bin) throw bad_input(fmt::format("{}: the records {}.bin are missing", place, entry.name));
  DecodedLog out = decode_bytes(*log.xml, *log.bin, tasks.elements, place);
  out.entry = entry;
  return out;
}

void append(WorkLog& all, WorkLog&& part, const LogEntry& entry, int unit, BoomList& booms) {
  const AmountUnit own_unit = part.rate_unit;
  if (all.rate_unit == AmountUnit::kUnknown) all.rate_unit = own_unit;
  const bool other_amounts = own_unit != AmountUnit::kUnknown && own_unit != all.rate_unit;
  if (other_amounts)
    all.notes.push_back(
        fmt::format("{}: its applied rates are in {}, those of the logs before in {}: they count "
                    "as not recorded",
                    entry.name, name(own_unit), name(all.rate_unit)));
  std::vector<int> numbers;
  for (const Boom& boom : part.booms) numbers.push_back(booms.number_of(boom));
  for (Fix fix : part.fixes) {
    fix.unit = unit;
    if (other_amounts) fix.rate_per_ha = std::numeric_limits<double>::quiet_NaN();
    if (fix.boom >= 0) fix.boom = numbers[static_cast<std::size_t>(fix.boom)];
    all.fixes.push_back(fix);
  }
  for (const SkippedRecord& skipped : part.skipped.listed)
    all.skipped.add(skipped.record, entry.name + ": " + skipped.why);
  all.skipped.count += part.skipped.count - part.skipped.listed.size();
  all.counters.add(part.counters);
  for (const std::string& note : part.notes) all.notes.push_back(entry.name + ": " + note);
}

/// One log as it is; several one after the other, each a unit.
WorkLog joined(std::vector<DecodedLog> logs) {
  if (logs.size() == 1) return std::move(logs.front().log);
  WorkLog all;
  all.clock = Clock::kUtc;
  BoomList booms;
  int unit = 0;
  for (DecodedLog& log : logs) append(all, std::move(log.log), log.entry, unit++, booms);
  all.booms = booms.booms();
  all.notes.push_back(fmt::format("{} logs were joined; each is evaluated as a unit of its own", unit));
  return all;
}

/// All logs that are meant, and what of them is left out.
struct DecodedLogs {
  std::vector<DecodedLog> logs;
  std::vector<std::string> notes;
};

DecodedLogs decoded(const TaskFiles& files, const TaskData& tasks, const std::string& wanted) {
  const std::vector<LogEntry> entries = chosen(files, tasks, wanted);
  DecodedLogs out;
  std::vector<std::string> left_out;
  std::size_t fixes = 0;
  for (const LogEntry& entry : entries) {
    const LogFiles log = files_of(files, entry);
    if ((!log.xml || !log.bin) && entries.size() > 1) {
      left_out.push_back(entry.name);
      continue;
    }
    require_room_for_log(out.logs.size(), "logs", fmt::format("'{}'", files.path()));
    out.logs.push_back(decode(files, log, entry, tasks));
    fixes += out.logs.back().log.fixes.size();
    if (fixes > 0) require_room_for_fix(fixes - 1, fmt::format("'{}'", files.path()));
  }
  if (!left_out.empty())
    out.notes.push_back(fmt::format("{} logs have no .xml or no .bin and were left out: {}", left_out.size(),
                                    fmt::join(left_out, ", ")));
  return out;
}

void require_fixes(const std::vector<DecodedLog>& logs, const std::string& path) {
  SkippedRecords skipped;
  for (const DecodedLog& log : logs) {
    if (!log.log.fixes.empty()) return;
    skipped.add(log.log.skipped);
  }
  throw bad_input(fmt::format("'{}' has no record with a possible position ({} were skipped{})", path,
                              skipped.count,
                              skipped.listed.empty() ? "" : ": " + skipped.listed.front().why));
}

std::vector<std::vector<std::size_t>> grouped(const std::vector<DecodedLog>& logs) {
  std::vector<JobFacts> facts;
  for (const DecodedLog& log : logs) {
    facts.push_back(facts_of(log.log));
    facts.back().field_id = log.entry.field_id;
    facts.back().devices = log.devices;
  }
  return job_groups(facts);
}

LogJob job_of(std::vector<DecodedLog> logs, const TaskData& tasks) {
  LogJob out;
  for (const DecodedLog& log : logs) {
    out.entries.push_back(log.entry);
    for (const std::string& id : log.devices) {
      const auto named = tasks.device_names.find(id);
      const std::string& name =
          named == tasks.device_names.end() || named->second.empty() ? id : named->second;
      if (!name.empty() && std::find(out.devices.begin(), out.devices.end(), name) == out.devices.end())
        out.devices.push_back(name);
    }
  }
  out.log = joined(std::move(logs));
  out.clock = out.log.clock;
  const JobFacts facts = facts_of(out.log);
  out.from_s = facts.from_s;
  out.to_s = facts.to_s;
  return out;
}

/// What could not be read, for messages: " (what: why)", or nothing.
std::string first_skipped(const RawDataset& dataset) {
  if (dataset.skipped.empty()) return "";
  return " (" + dataset.skipped.front().what + ": " + dataset.skipped.front().why + ")";
}

}  // namespace

WorkLog decode_time_log(std::string_view header_xml, std::string_view bytes,
                        const std::vector<DeviceElement>& elements, const std::string& place) {
  return decode_bytes(header_xml, bytes, elements, place).log;
}

WorkLog read_task_log(const std::string& path, const std::string& wanted) {
  const TaskFiles files = TaskFiles::open(path);
  DecodedLogs all = decoded(files, read_task_data(files), wanted);
  require_fixes(all.logs, path);
  WorkLog out = joined(std::move(all.logs));
  out.notes.insert(out.notes.end(), all.notes.begin(), all.notes.end());
  return out;
}

std::vector<LogJob> read_task_jobs(const std::string& path, const std::string& wanted) {
  const TaskFiles files = TaskFiles::open(path);
  const TaskData tasks = read_task_data(files);
  DecodedLogs all = decoded(files, tasks, wanted);
  require_fixes(all.logs, path);
  std::vector<LogJob> out;
  std::vector<std::string> empty;
  for (const std::vector<std::size_t>& group : grouped(all.logs)) {
    std::vector<DecodedLog> logs;
    for (const std::size_t i : group) logs.push_back(std::move(all.logs[i]));
    if (logs.front().log.fixes.empty())
      empty.push_back(logs.front().entry.name);
    else
      out.push_back(job_of(std::move(logs), tasks));
  }
  std::vector<std::string>& notes = out.front().log.notes;
  notes.insert(notes.end(), all.notes.begin(), all.notes.end());
  if (!empty.empty())
    notes.push_back(fmt::format("{} logs have no record with a possible position and were left out: {}",
                                empty.size(), fmt::join(empty, ", ")));
  return out;
}

std::vector<LogEntry> list_task_logs(const std::string& path) {
  const TaskFiles files = TaskFiles::open(path);
  if (!files.only_log().empty()) return {{files.only_log(), "", "", ""}};
  return read_task_data(files).logs;
}

RawDataset read_partfields(const std::string& path) {
  RawDataset out = read_task_data(TaskFiles::open(path)).partfields;
  if (out.layers.empty() || out.layers.front().name != "partfields")
    throw bad_input(fmt::format("'{}' has no partfield with a boundary{}", path, first_skipped(out)));
  return out;
}

RawDataset read_guidance(const std::string& path) {
  RawDataset out = read_task_data(TaskFiles::open(path)).guidance;
  if (out.layers.empty())
    throw bad_input(
        fmt::format("'{}' has no guidance line that tracks could follow{}", path, first_skipped(out)));
  return out;
}

}  // namespace tramline::io
