#include "tramline/coverage/live/live_coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/coverage/doubts.h"
#include "tramline/coverage/drive/step_maker.h"
#include "tramline/coverage/drive/working_boom.h"

namespace tramline::coverage {
namespace {

/// Late fixes make all work anew when the log has grown by this share of it.
constexpr std::size_t kGrowth = 8;

constexpr double kBefore_s = -std::numeric_limits<double>::infinity();

}  // namespace

LiveCoverage::LiveCoverage(const Region& field, const EvaluateSettings& settings)
    : field_(&field),
      settings_(settings),
      width_m_(settings.drive.width_m),
      last_key_s_(kBefore_s),
      front_key_s_(kBefore_s),
      rate_(settings.drive.max_gap_s) {}

void LiveCoverage::take_booms(std::span<const Boom> booms) {
  for (std::size_t i = log_.booms.size(); i < booms.size(); ++i) {
    const std::optional<Boom> one = mended(booms[i]);
    log_.booms.push_back(booms[i]);
    booms_.push_back(one.value_or(booms[i]));
    changed_.push_back(one ? 1 : 0);
  }
}

Fix LiveCoverage::mended_fix(Fix fix) const {
  if (fix.boom >= 0 && changed_[static_cast<std::size_t>(fix.boom)] != 0) fix = with_one_section(fix);
  if (trust_.ignored()) fix.has_sections = false;
  return fix;
}

/// What the fix changes in the judgement of the log; true where those before it have to be worked anew at
/// once.
bool LiveCoverage::judge(const Fix& fix) {
  const bool ignored = trust_.ignored(), said = says_work_;
  trust_.add(fix);
  says_work_ = says_work_ || fix.work != WorkState::kUnknown || fix.has_sections;
  const double width_before_m = width_m_;
  if (fix.boom >= 0) width_m_ = std::fmax(width_m_, span_m(booms_[static_cast<std::size_t>(fix.boom)]));

  if (!std::isnan(fix.time_s)) {
    const auto [last, first] = latest_s_.try_emplace(fix.unit, fix.time_s);
    if (!first && fix.time_s < last->second) {
      ++late_;
      disordered_ = owed_ = true;
    }
    last->second = fix.time_s;
    last_key_s_ = fix.time_s;
  }
  if (disordered_ && last_key_s_ < front_key_s_) owed_ = true;
  front_key_s_ = std::max(front_key_s_, last_key_s_);

  const bool first_width = !(width_before_m > 0) && width_m_ > 0;
  return log_.fixes.size() > 1 && (ignored != trust_.ignored() || said != says_work_ || first_width);
}

void LiveCoverage::work(const Fix& fix) {
  drive_->add(fix, booms_);
  const CoverageAreas areas = drive_->areas();
  rate_.add(fix.time_s, field_->empty() ? areas.covered_m2 : areas.covered_inside_m2);
}

void LiveCoverage::add(const Fix& fix, std::span<const Boom> booms) {
  take_booms(booms);
  log_.fixes.push_back(fix);
  ++since_rebuild_;
  const bool at_once = judge(fix);
  const bool overdue = owed_ && since_rebuild_ * kGrowth >= log_.fixes.size();
  if (at_once || overdue) return rebuild();
  if (!(width_m_ > 0)) return;
  if (!drive_) {
    DriveSettings drive = settings_.drive;
    drive.unknown_work = unknown_work();
    drive_.emplace(*field_, settings_, drive, width_m_, most_sections(booms_));
  }
  work(mended_fix(fix));
}

void LiveCoverage::rebuild() {
  ++rebuilds_;
  since_rebuild_ = 0;
  owed_ = false;
  const PreparedLog ready = prepared(log_, settings_.drive);
  rate_ = WorkRate(settings_.drive.max_gap_s);
  drive_.reset();
  if (!(ready.width_m > 0)) return;
  drive_.emplace(*field_, settings_, ready.drive, ready.width_m, most_sections(ready.log.booms));
  for (const Fix& fix : ready.log.fixes) work(fix);
}

void LiveCoverage::settle() {
  if (owed_) rebuild();
}

void LiveCoverage::restart(WorkLog log) {
  const std::size_t rebuilds = rebuilds_;
  *this = LiveCoverage(*field_, settings_);
  rebuilds_ = rebuilds;
  take_booms(log.booms);
  log_.fixes.reserve(log.fixes.size());
  for (const Fix& fix : log.fixes) {
    log_.fixes.push_back(fix);
    judge(fix);
  }
  rebuild();
}

CoverageAreas LiveCoverage::areas() const {
  if (drive_) return reported(drive_->areas(), settings_.repeat);
  CoverageAreas out;
  out.missed_m2 = out.worked_times_m2[0] = area(*field_);
  return out;
}

std::optional<bool> LiveCoverage::working() const {
  if (log_.fixes.empty()) return std::nullopt;
  const Fix fix = mended_fix(log_.fixes.back());
  const Boom one{{1, -1}};
  return !working_boom(fix, fix.boom >= 0 ? booms_[static_cast<std::size_t>(fix.boom)] : one, unknown_work())
              .empty();
}

std::optional<Ahead> LiveCoverage::look_ahead(const SwitchRule& rule) const {
  const std::optional<Motion> motion = drive_ ? drive_->motion() : std::nullopt;
  if (!motion || drive_->engine().tiles() == nullptr) return std::nullopt;
  const Fix fix = mended_fix(log_.fixes.back());
  const double half_m = settings_.drive.width_m / 2;
  Ahead out{fix.boom >= 0 ? booms_[static_cast<std::size_t>(fix.boom)] : Boom{{half_m, -half_m}}, {}};
  if (std::isnan(span_m(out.boom))) return std::nullopt;
  const Boom working = working_boom(fix, out.boom, unknown_work());
  std::vector<SectionState> states;
  for (const Section& section : out.boom) {
    const double middle_m = 0.5 * (section.left_m + section.right_m);
    const bool on = std::any_of(working.begin(), working.end(), [&](const Section& run) {
      return run.right_m < middle_m && middle_m < run.left_m;
    });
    states.push_back({on, {}});
  }
  out.sections = coverage::look_ahead(*drive_->engine().tiles(), *field_, *motion, out.boom, states, rule);
  return out;
}

double LiveCoverage::last_s() const {
  return log_.fixes.empty() ? std::numeric_limits<double>::quiet_NaN() : log_.fixes.back().time_s;
}

Coverage LiveCoverage::figures(const WorkLog& head) const {
  Coverage out;
  out.log = head.name;
  out.engine = name(settings_.engine);
  out.width_m = width_m_;
  out.fixes_used = log_.fixes.size();
  out.skipped = head.skipped;
  out.fixes = out.fixes_used + out.skipped.count;
  WorkLog mend;
  mend.booms = log_.booms;
  out.warnings = head.notes;
  for (std::string& note : log_without_faults(std::move(mend)).notes) out.warnings.push_back(std::move(note));
  if (trust_.ignored()) out.warnings.emplace_back(kSectionsIgnored);
  if (late_ > 0) out.warnings.push_back(note_on_disorder(late_));
  if (!drive_) {
    out.areas = areas();
    return out;
  }
  drive_->add_figures(out, head.clock);
  for (std::string& doubt : doubts_on(drive_->areas(), head.counters, width_m_))
    out.warnings.push_back(std::move(doubt));
  return out;
}

Coverage LiveCoverage::coverage(const WorkLog& head) const {
  assert(settled());
  Coverage out = figures(head);
  if (drive_) drive_->add_regions(out);
  return out;
}

}  // namespace tramline::coverage
