#include "tramline/coverage/live/live_coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "tramline/coverage/ahead/look_ahead.h"
#include "tramline/coverage/doubts.h"
#include "tramline/coverage/drive/log_sanity.h"
#include "tramline/coverage/drive/worked_drive.h"
#include "tramline/coverage/drive/working_boom.h"
#include "tramline/coverage/live/work_rate.h"

namespace tramline::coverage {
namespace {

/// Late fixes make all work anew when the log has grown by this share of it.
constexpr std::size_t kGrowth = 8;

constexpr double kBefore_s = -std::numeric_limits<double>::infinity();

}  // namespace

/// What has come so far, and what has been made of it.
struct LiveCoverage::State {
  State(const Region& ground, const EvaluateSettings& with);

  void add(const Fix& fix, std::span<const Boom> booms);
  void take_booms(std::span<const Boom> booms);
  bool judge(const Fix& fix);
  Fix mended_fix(Fix fix) const;
  /// Where nothing is said of the work, all of it counts; where something is, only what is said.
  WorkState unknown_work() const { return says_work ? WorkState::kOff : WorkState::kOn; }
  void work(const Fix& fix);
  void rebuild();

  const Region* field;
  EvaluateSettings settings;
  WorkLog log;                     ///< as it came
  std::vector<Boom> mended_booms;  ///< of the log
  std::vector<char> changed;       ///< which of them were mended
  double width_m;
  SectionTrust trust;
  bool says_work = false;
  std::map<int, double> latest_s;  ///< of each unit
  double last_key_s = kBefore_s;   ///< time of the last fix that had one
  double latest_key_s = kBefore_s;
  bool disordered = false;
  std::size_t late = 0;
  bool owed = false;
  std::size_t since_rebuild = 0;
  std::size_t rebuilds = 0;
  std::optional<WorkedDrive> drive;  ///< none before a width is known
  WorkRate rate;
};

LiveCoverage::State::State(const Region& ground, const EvaluateSettings& with)
    : field(&ground), settings(with), width_m(with.drive.width_m), rate(with.drive.max_gap_s) {}

void LiveCoverage::State::take_booms(std::span<const Boom> booms) {
  for (std::size_t i = log.booms.size(); i < booms.size(); ++i) {
    const std::optional<Boom> one = mended(booms[i]);
    log.booms.push_back(booms[i]);
    mended_booms.push_back(one.value_or(booms[i]));
    changed.push_back(one ? 1 : 0);
  }
}

Fix LiveCoverage::State::mended_fix(Fix fix) const {
  if (fix.boom >= 0 && changed[static_cast<std::size_t>(fix.boom)] != 0) fix = with_one_section(fix);
  if (trust.ignored()) fix.has_sections = false;
  return fix;
}

/// What the fix changes in the judgement of the log; true where those before it have to be worked anew at
/// once.
bool LiveCoverage::State::judge(const Fix& fix) {
  const bool ignored = trust.ignored(), said = says_work;
  trust.add(fix);
  says_work = says_work || fix.work != WorkState::kUnknown || fix.has_sections;
  const double width_before_m = width_m;
  if (fix.boom >= 0) width_m = std::fmax(width_m, span_m(mended_booms[static_cast<std::size_t>(fix.boom)]));

  if (!std::isnan(fix.time_s)) {
    const auto [last, first] = latest_s.try_emplace(fix.unit, fix.time_s);
    if (!first && fix.time_s < last->second) {
      ++late;
      disordered = owed = true;
    }
    last->second = fix.time_s;
    last_key_s = fix.time_s;
  }
  if (disordered && last_key_s < latest_key_s) owed = true;
  latest_key_s = std::max(latest_key_s, last_key_s);

  const bool first_width = !(width_before_m > 0) && width_m > 0;
  return log.fixes.size() > 1 && (ignored != trust.ignored() || said != says_work || first_width);
}

void LiveCoverage::State::work(const Fix& fix) {
  drive->add(fix, mended_booms);
  const CoverageAreas areas = drive->areas();
  rate.add(fix.time_s, field->empty() ? areas.covered_m2 : areas.covered_inside_m2);
}

LiveCoverage::LiveCoverage(const Region& field, const EvaluateSettings& settings)
    : state_(std::make_unique<State>(field, settings)) {}

LiveCoverage::LiveCoverage(LiveCoverage&& other) noexcept = default;
LiveCoverage& LiveCoverage::operator=(LiveCoverage&& other) noexcept = default;
LiveCoverage::~LiveCoverage() = default;

bool LiveCoverage::settled() const { return !state_->owed; }
std::size_t LiveCoverage::fixes() const { return state_->log.fixes.size(); }
const WorkedDrive* LiveCoverage::drive() const { return state_->drive ? &*state_->drive : nullptr; }
std::size_t LiveCoverage::rebuilds() const { return state_->rebuilds; }
double LiveCoverage::present_m2_per_s() const { return state_->rate.m2_per_s(); }

void LiveCoverage::add(const Fix& fix, std::span<const Boom> booms) { state_->add(fix, booms); }

void LiveCoverage::State::add(const Fix& fix, std::span<const Boom> booms) {
  take_booms(booms);
  log.fixes.push_back(fix);
  ++since_rebuild;
  const bool at_once = judge(fix);
  const bool overdue = owed && since_rebuild * kGrowth >= log.fixes.size();
  if (at_once || overdue) return rebuild();
  if (!(width_m > 0)) return;
  if (!drive) {
    DriveSettings with = settings.drive;
    with.unknown_work = unknown_work();
    drive.emplace(*field, settings, with, width_m, most_sections(mended_booms));
  }
  work(mended_fix(fix));
}

void LiveCoverage::State::rebuild() {
  ++rebuilds;
  since_rebuild = 0;
  owed = false;
  const PreparedLog ready = prepared(log, settings.drive);
  rate = WorkRate(settings.drive.max_gap_s);
  drive.reset();
  if (!(ready.width_m > 0)) return;
  drive.emplace(*field, settings, ready.drive, ready.width_m, most_sections(ready.log.booms));
  for (const Fix& fix : ready.log.fixes) work(fix);
}

void LiveCoverage::settle() {
  if (state_->owed) state_->rebuild();
}

void LiveCoverage::restart(WorkLog log) {
  const std::size_t rebuilds = state_->rebuilds;
  *state_ = State(*state_->field, state_->settings);
  state_->rebuilds = rebuilds;
  state_->take_booms(log.booms);
  state_->log.fixes.reserve(log.fixes.size());
  for (const Fix& fix : log.fixes) {
    state_->log.fixes.push_back(fix);
    state_->judge(fix);
  }
  state_->rebuild();
}

CoverageAreas LiveCoverage::areas() const {
  if (state_->drive) return reported(state_->drive->areas(), state_->settings.repeat);
  CoverageAreas out;
  out.missed_m2 = out.worked_times_m2[0] = area(*state_->field);
  return out;
}

std::optional<bool> LiveCoverage::working() const {
  if (state_->log.fixes.empty()) return std::nullopt;
  const Fix fix = state_->mended_fix(state_->log.fixes.back());
  const Boom one{{1, -1}};
  return !working_boom(fix, fix.boom >= 0 ? state_->mended_booms[static_cast<std::size_t>(fix.boom)] : one,
                       state_->unknown_work())
              .empty();
}

std::optional<Ahead> LiveCoverage::look_ahead(const SwitchRule& rule) const {
  const std::optional<Motion> motion = state_->drive ? state_->drive->motion() : std::nullopt;
  if (!motion || state_->drive->engine().tiles() == nullptr) return std::nullopt;
  const Fix fix = state_->mended_fix(state_->log.fixes.back());
  const double half_m = state_->settings.drive.width_m / 2;
  Ahead out{
      fix.boom >= 0 ? state_->mended_booms[static_cast<std::size_t>(fix.boom)] : Boom{{half_m, -half_m}}, {}};
  if (std::isnan(span_m(out.boom))) return std::nullopt;
  const Boom working = working_boom(fix, out.boom, state_->unknown_work());
  std::vector<SectionState> states;
  for (const Section& section : out.boom) {
    const double middle_m = 0.5 * (section.left_m + section.right_m);
    const bool on = std::any_of(working.begin(), working.end(), [&](const Section& run) {
      return run.right_m < middle_m && middle_m < run.left_m;
    });
    states.push_back({on, {}});
  }
  out.sections =
      coverage::look_ahead(*state_->drive->engine().tiles(), *state_->field, *motion, out.boom, states, rule);
  return out;
}

double LiveCoverage::last_s() const {
  return state_->log.fixes.empty() ? std::numeric_limits<double>::quiet_NaN()
                                   : state_->log.fixes.back().time_s;
}

Coverage LiveCoverage::figures(const WorkLog& head) const {
  Coverage out;
  out.log = head.name;
  out.engine = name(state_->settings.engine);
  out.width_m = state_->width_m;
  out.fixes_used = state_->log.fixes.size();
  out.skipped = head.skipped;
  out.fixes = out.fixes_used + out.skipped.count;
  WorkLog mend;
  mend.booms = state_->log.booms;
  out.warnings = head.notes;
  for (std::string& note : log_without_faults(std::move(mend)).notes) out.warnings.push_back(std::move(note));
  if (state_->trust.ignored()) out.warnings.emplace_back(kSectionsIgnored);
  if (state_->late > 0) out.warnings.push_back(note_on_disorder(state_->late));
  if (!state_->drive) {
    out.areas = areas();  // no meshes: an engine is made when a width is known
    return out;
  }
  state_->drive->add_figures(out, head.clock);
  for (std::string& doubt : doubts_on(state_->drive->areas(), head.counters, state_->width_m))
    out.warnings.push_back(std::move(doubt));
  return out;
}

Coverage LiveCoverage::coverage(const WorkLog& head) const {
  assert(settled());
  Coverage out = figures(head);
  if (state_->drive) state_->drive->add_regions(out);
  return out;
}

}  // namespace tramline::coverage
