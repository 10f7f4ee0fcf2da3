#include "tramline/render/close_up/close_up_content.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>

#include "tramline/render/close_up/close_up_window.h"
#include "tramline/render/page/visible_faults.h"
#include "tramline/render/stops/stop_places.h"

namespace tramline::render {
namespace {

constexpr std::size_t kMostRows = 24;

bool concerns(const Encounter& encounter, std::size_t obstacle) {
  return std::find(encounter.obstacles.begin(), encounter.obstacles.end(), obstacle) !=
         encounter.obstacles.end();
}

// "−14.30", with the sign that print has for it.
std::string signed_text(double cost) {
  std::string digits = fmt::format("{:.2f}", std::abs(cost));
  if (digits == "0.00") return digits;
  return (cost < 0 ? "−" : "+") + digits;
}

/// The detour that passes the place of an encounter; nullptr where the track is cut.
const Detour* detour_at(const Plan& plan, const Encounter& encounter) {
  if (encounter.chosen == Passing::kCut) return nullptr;
  for (const TrackPiece& piece : plan.pieces) {
    if (piece.subfield != encounter.subfield || piece.track != encounter.track) continue;
    for (const Detour& detour : piece.detours) {
      // Both ends and the place lie on the line of the piece.
      const Point from = detour.path.front().from, along = detour.path.back().to - from;
      const double run = dot(encounter.at - from, along);
      if (run >= 0 && run <= dot(along, along)) return &detour;
    }
  }
  return nullptr;
}

/// How many meetings of its track a detour passes; 0 for none.
std::ptrdiff_t meetings_passed(const Plan& plan, const Encounter& one, const Detour* detour) {
  if (detour == nullptr) return 0;
  return std::count_if(plan.encounters.begin(), plan.encounters.end(), [&](const Encounter& other) {
    return other.subfield == one.subfield && other.track == one.track && detour_at(plan, other) == detour;
  });
}

std::string way_text(const WayPast& way) {
  if (way.possible) return signed_text(way.cost);
  return way.why_not.empty() ? "no" : "no: " + way.why_not;
}

std::string chosen_text(const Encounter& encounter, std::size_t obstacle, const Detour* detour) {
  std::set<std::size_t> together(encounter.obstacles.begin(), encounter.obstacles.end());
  if (detour != nullptr) together.insert(detour->obstacles.begin(), detour->obstacles.end());
  std::string others;
  for (const std::size_t other : together)
    if (other != obstacle) others += fmt::format("{}{}", others.empty() ? "" : ", ", other + 1);
  return others.empty() ? name(encounter.chosen)
                        : fmt::format("{} (with {})", name(encounter.chosen), others);
}

/// The rows of one obstacle, one after the other.
class EncounterRows {
 public:
  EncounterRows(const Plan& plan, std::size_t obstacle) : plan_(plan), obstacle_(obstacle) {}

  EncounterRow next(const Encounter& encounter) {
    const Detour* detour = detour_at(plan_, encounter);
    EncounterRow out{strip_name(plan_, encounter.subfield, encounter.track),
                     chosen_text(encounter, obstacle_, detour), way_text(encounter.left),
                     way_text(encounter.right)};
    const auto meetings = meetings_passed(plan_, encounter, detour);
    if (meetings > 1) tell_joint(encounter.chosen == Passing::kLeft ? out.left : out.right, detour, meetings);
    return out;
  }

 private:
  /// A detour that passes several meetings costs what it costs once, not at each of them.
  void tell_joint(std::string& cost, const Detour* detour, std::ptrdiff_t meetings) {
    if (!listed_.insert({detour, cost}).second)
      cost = "joint, counted above";
    else
      cost += fmt::format(", joint for {} meetings", meetings);
  }

  const Plan& plan_;
  std::size_t obstacle_;
  std::set<std::pair<const Detour*, std::string>> listed_;
};

bool inside(Point p, const Box& box) {
  return p.x >= box.min_x && p.x <= box.max_x && p.y >= box.min_y && p.y <= box.max_y;
}

bool shows_stop(const Plan& near, const Box& seen) {
  return std::ranges::any_of(stop_places(near), [&](const StopPlace& stop) { return inside(stop.at, seen); });
}

bool shows_detour(const Plan& near, const Box& seen) {
  for (const TrackPiece& piece : near.pieces)
    for (const Detour& detour : piece.detours)
      if (intersects(box_of(detour.path), seen)) return true;
  return false;
}

bool shows_passable(const Plan& near, const Box& seen) {
  return std::any_of(near.field.obstacles.begin(), near.field.obstacles.end(), [&](const Obstacle& obstacle) {
    return obstacle.kind == ObstacleKind::kPassable && intersects(bounds(obstacle.shape), seen);
  });
}

struct DetoursRound {
  int left = 0;
  int right = 0;
  double smallest_radius_m = std::numeric_limits<double>::infinity();
};

DetoursRound detours_round(const Plan& plan, std::size_t obstacle) {
  DetoursRound out;
  for (const TrackPiece& piece : plan.pieces) {
    for (const Detour& detour : piece.detours) {
      if (!avoids(detour, obstacle)) continue;
      ++(detour.side == Passing::kLeft ? out.left : out.right);
      out.smallest_radius_m = std::min(out.smallest_radius_m, smallest_radius(detour.path));
    }
  }
  return out;
}

LegendBlock symbols(const Plan& near, const Box& seen, const DetoursRound& detours) {
  LegendBlock block{"Legend", {}};
  const auto add = [&](bool occurs, Symbol symbol, const std::string& text) {
    if (occurs) block.rows.push_back({symbol, 0, text, ""});
  };
  add(true, Symbol::kObstacle, "obstacle and its number");
  add(shows_passable(near, seen), Symbol::kPassable, "passable obstacle");
  add(true, Symbol::kKeepOff, fmt::format("nearest a detour may pass: {:.2f} m", keep_off_m(near)));
  add(!near.headland.ground.empty(), Symbol::kHeadland, "headland");
  add(!near.headland.passes.empty(), Symbol::kHeadlandPass, "headland pass");
  add(!near.pieces.empty() || !near.headland.passes.empty(), Symbol::kSwathEdge, "swath");
  const bool several = near.subfields.size() > 1;
  add(!near.pieces.empty(), Symbol::kTrack, several ? "track: subfield/number" : "track and its number");
  add(shows_detour(near, seen), Symbol::kDetour, "detour round an obstacle");
  add(!references(near).empty(), Symbol::kReference, "line that tracks follow");
  add(detours.left + detours.right > 0, Symbol::kTightestArc, "tightest arc of a detour");
  add(!near.dropped.empty(), Symbol::kDropped, "dropped: not worth driving");
  add(shows_stop(near, seen), Symbol::kStop, "stop: the machine backs out");
  add(!near.given_up.empty(), Symbol::kGivenUp, "given up on purpose");
  add(!visible_faults(near.overlap).empty(), Symbol::kOverlap, "overlap");
  const bool unworked = !visible_faults(near.headland.unworked).empty();
  add(unworked || !visible_faults(near.uncovered).empty(), Symbol::kUncovered, "uncovered");
  return block;
}

LegendBlock numbers(const Plan& plan, std::size_t obstacle, const DetoursRound& detours) {
  LegendBlock block{"Numbers", {}};
  const auto add = [&](const char* text, std::string value) {
    block.rows.push_back({Symbol::kNone, 0, text, std::move(value)});
  };
  const auto meetings = std::count_if(plan.encounters.begin(), plan.encounters.end(),
                                      [&](const Encounter& e) { return concerns(e, obstacle); });
  const auto cuts = std::count_if(plan.encounters.begin(), plan.encounters.end(), [&](const Encounter& e) {
    return concerns(e, obstacle) && e.chosen == Passing::kCut;
  });
  add("obstacle", area_text(area(plan.field.obstacles[obstacle].shape)));
  add("meetings with tracks", std::to_string(meetings));
  const bool any = detours.left + detours.right > 0;
  add("detours", any ? fmt::format("{} left, {} right", detours.left, detours.right) : std::string("0"));
  add("cut", std::to_string(cuts));
  if (std::isfinite(detours.smallest_radius_m))
    add("tightest arc", fmt::format("{:.2f} m", detours.smallest_radius_m));
  add("turning radius", fmt::format("{:g} m", plan.machine.radius_m));
  add("clearance", fmt::format("{:g} m", plan.settings.clearance_m));
  return block;
}

}  // namespace

std::string close_up_title(const Plan& plan, std::size_t obstacle) {
  const std::string& origin = plan.field.obstacles[obstacle].origin;
  return origin.empty() ? fmt::format("obstacle {}", obstacle + 1)
                        : fmt::format("obstacle {} ({})", obstacle + 1, origin);
}

std::string close_up_subtitle(const Plan& plan) {
  return fmt::format("{}, working width {:g} m", plan.field.id.empty() ? "field" : plan.field.id,
                     plan.machine.width_m);
}

double keep_off_m(const Plan& plan) { return 0.5 * plan.machine.width_m + plan.settings.clearance_m; }

std::string strip_name(const Plan& plan, std::size_t subfield, int track) {
  return plan.subfields.size() > 1 ? fmt::format("{}/{}", subfield + 1, track + 1)
                                   : std::to_string(track + 1);
}

std::vector<LegendBlock> legend_of_close_up(const Plan& plan, std::size_t obstacle, const Box& seen) {
  const DetoursRound detours = detours_round(plan, obstacle);
  return {symbols(part_in(plan, seen), seen, detours), numbers(plan, obstacle, detours)};
}

std::vector<EncounterRow> encounter_rows(const Plan& plan, std::size_t obstacle) {
  std::vector<EncounterRow> out;
  EncounterRows rows(plan, obstacle);
  for (const Encounter& encounter : plan.encounters)
    if (concerns(encounter, obstacle)) out.push_back(rows.next(encounter));
  if (out.size() > kMostRows) {
    const std::size_t left_out = out.size() - (kMostRows - 1);
    out.resize(kMostRows - 1);
    out.push_back({fmt::format("and {} more", left_out), "", "", "", true});
  }
  return out;
}

}  // namespace tramline::render
