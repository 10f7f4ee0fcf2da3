#include "tramline/coverage/drive/step_maker.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "tramline/coverage/drive/worked_drive.h"
#include "tramline/coverage/drive/working_boom.h"

namespace tramline::coverage {
namespace {

bool has(const Boom& boom, const Section& section) {
  return std::find(boom.begin(), boom.end(), section) != boom.end();
}

/// Switched half way; a run of sections that works on both sides is one quad.
std::vector<QuadOrigin> switched_half_way(const Boom& before, const Boom& after) {
  std::vector<QuadOrigin> out;
  for (const Section& section : before) out.push_back({section, 0, has(after, section) ? 1 : 0.5});
  for (const Section& section : after)
    if (!has(before, section)) out.push_back({section, 0.5, 1});
  return out;
}

}  // namespace

Boom StepMaker::working_at(const Fix& fix, const std::vector<Boom>& booms) {
  const double half_m = settings_.width_m / 2;
  const Boom boom = fix.boom >= 0 ? booms[static_cast<std::size_t>(fix.boom)] : Boom{{half_m, -half_m}};
  if (fix.boom < 0 && std::isnan(half_m) && fix.work != WorkState::kOff) ++breaks_.without_width;
  return working_boom(fix, boom, settings_.unknown_work);
}

bool StepMaker::joins(const End& from, const End& to) {
  const double time_s = to.time_s - from.time_s;  // NaN without times: nothing is known against it
  const bool matters = !from.working.empty() || !to.working.empty();
  const auto broken = [&](std::size_t& count) {
    if (matters) ++count;
    return false;
  };
  if (time_s < 0) return broken(breaks_.backwards);
  if (time_s > settings_.max_gap_s) return broken(breaks_.gaps);
  if (distance(from.antenna, to.antenna) > settings_.max_step_m) return broken(breaks_.jumps);
  return true;
}

Point StepMaker::middle(const End& end, Heading heading) const {
  const Point left = left_of(heading.unit());
  return end.antenna - (settings_.antenna_forward_m + settings_.implement_behind_m) * heading.unit() +
         settings_.antenna_right_m * left;
}

/// Nothing joins the fix to those before it.
void StepMaker::begin_anew(Unit& unit, const End& to) {
  if (unit.hole) close_hole(unit);
  Unit fresh;
  fresh.usual = unit.usual;
  const bool backwards = unit.last && to.time_s < unit.last->time_s;
  if (unit.last && !backwards && !unit.last->working.empty() && !to.working.empty())
    fresh.hole = Hole{*unit.last, to};
  unit = std::move(fresh);
}

void StepMaker::close_hole(Unit& unit) {
  const auto end_of_hole = [&](const End& end) {
    return HoleEnd{end.time_s, end.heading ? middle(end, *end.heading) : end.antenna, end.heading,
                   end.working};
  };
  const std::vector<Quad> strip = hole_strip(end_of_hole(unit.hole->before), end_of_hole(unit.hole->after),
                                             unit.usual.mps(), settings_.quads);
  if (!strip.empty()) ++breaks_.holes;
  unrecorded_.insert(unrecorded_.end(), strip.begin(), strip.end());
  unit.hole.reset();
}

StepMaker::Bars StepMaker::bars(const End& from, const End& to) const {
  Heading rear = from.heading ? *from.heading : *to.heading;
  Heading front = *to.heading;
  if (settings_.quads == QuadShape::kSegment) {
    const Heading course = Heading::from_to(from.antenna, to.antenna);
    const bool back = reverses(front, course);
    rear = front = back ? Heading::from_to(to.antenna, from.antenna) : course;
  }
  return {{middle(from, rear), left_of(rear.unit())}, {middle(to, front), left_of(front.unit())}};
}

std::optional<WorkedStep> StepMaker::step(Unit& unit, const End& to) {
  const End& from = *unit.last;
  WorkedStep out;
  const Boom& after = settings_.switching == Switching::kStep ? from.working : to.working;
  out.origins = switched_half_way(from.working, after);
  if (out.origins.empty()) return std::nullopt;
  const Bars ends = bars(from, to);
  out.quads.reserve(out.origins.size());
  const auto position = [&ends](double offset_m, double share) {
    return (1 - share) * ends.rear.at(offset_m) + share * ends.front.at(offset_m);
  };
  for (const auto& [section, begin, until] : out.origins)
    out.quads.push_back({position(section.left_m, begin), position(section.right_m, begin),
                         position(section.right_m, until), position(section.left_m, until)});
  out.way_m = distance(ends.rear.middle, ends.front.middle);
  out.seconds = from.stood_s + to.time_s - from.time_s;
  unit.usual.add(out.way_m, to.time_s - from.time_s);
  out.rate_before_per_ha = from.rate_per_ha;
  out.rate_after_per_ha = to.rate_per_ha;
  if (unit.run < 0) {
    unit.run = runs_++;
    unit.travel_m = 0;
  }
  const double step_m = distance(from.antenna, to.antenna);
  unit.travel_m += step_m;
  worked_m_ += step_m;
  // Units that work side by side work the same time.
  worked_s_ += std::max(0.0, to.time_s - std::max(from.time_s, worked_until_s_));
  worked_until_s_ = std::fmax(worked_until_s_, to.time_s);
  out.run = unit.run;
  out.travel_m = unit.travel_m;
  out.reach_m = step_m + std::max(span_m(from.working), span_m(to.working));
  out.fix = fixes_ - 1;
  return out;
}

std::optional<WorkedStep> StepMaker::add(const Fix& fix, const std::vector<Boom>& booms) {
  assert(std::isfinite(fix.position.x) && std::isfinite(fix.position.y));
  ++fixes_;
  Unit& unit = units_[fix.unit];
  End to{fix.time_s, fix.position, std::nullopt, working_at(fix, booms), fix.rate_per_ha};
  const bool joined = unit.last && joins(*unit.last, to);
  continuity_ = joined ? Continuity::kJoined : Continuity::kBroken;
  unrecorded_.clear();
  if (!joined) begin_anew(unit, to);
  heading_check_.add(fix, continuity_);
  const Heading logged = heading_read_as(settings_.headings, fix);
  const bool recorded = !std::isnan(logged.degrees());
  const std::optional<Heading> course = unit.course.at(to.antenna);
  to.heading = recorded ? std::optional(logged) : course;
  if (unit.hole && to.heading) {
    unit.hole->after.heading = to.heading;
    close_hole(unit);
  }
  heading_ = to.heading;
  position_ = to.heading ? middle(to, *to.heading) : to.antenna;
  if (!unit.last) {
    unit.last = std::move(to);
    return std::nullopt;
  }
  const bool needs_way = settings_.quads == QuadShape::kSegment || !recorded;
  const bool too_short = needs_way && distance(unit.last->antenna, to.antenna) < kLeastStep_m;
  if (!to.heading || too_short) {
    if (!unit.last->working.empty()) unit.last->stood_s += to.time_s - unit.last->time_s;
    unit.last->time_s = to.time_s;
    unit.last->rate_per_ha = to.rate_per_ha;
    unit.last->working = std::move(to.working);
    if (unit.last->working.empty()) unit.run = -1;
    return std::nullopt;
  }
  std::optional<WorkedStep> out = step(unit, to);
  if (to.working.empty()) unit.run = -1;
  unit.last = std::move(to);
  return out;
}

bool says_work(const WorkLog& log) {
  return std::any_of(log.fixes.begin(), log.fixes.end(),
                     [](const Fix& fix) { return fix.work != WorkState::kUnknown || fix.has_sections; });
}

}  // namespace tramline::coverage
