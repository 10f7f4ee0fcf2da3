#include "tramline/io/plan/plan_metadata.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/field/field_values.h"
#include "tramline/io/geopackage/key_values.h"
#include "tramline/io/geopackage/local_crs.h"
#include "tramline/io/plan/machine_values.h"
#include "tramline/io/plan/plan_keys.h"
#include "tramline/io/plan/plan_layers.h"
#include "tramline/io/plan/route_rows.h"

namespace tramline::io {
namespace {

constexpr const char* kFormat = "tramline plan";
constexpr int kNewestVersion = kVersionWithRoute, kOldestVersion = 2;
constexpr const char* kTracks = "settings.tracks";
constexpr const char* kAvoidRoom = "settings.avoid_room_m";  // only where there is a limit
constexpr const char* kAbAnchor = "settings.ab_anchor";
constexpr const char* kHeadlandEdges = "settings.headland_edges";
constexpr const char* kAim = "settings.aim";
constexpr const char* kEdgePasses = "headland.edge_passes";
constexpr const char* kHeadlandConstruction = "headland.construction";
constexpr const char* kOrigin = "origin";          // only where it is not `planned`
constexpr const char* kReference = "reference";    // of all subfields
constexpr const char* kReferences = "references";  // by subfield, where they have not all the same
constexpr const char* kKind = "kind";
constexpr const char* kRepair = "repair";
constexpr const char* kGivenBy = "subfields.given_by";  // by subfield, where any was drawn
constexpr const char* kLeftOut = "given_up.left_out";   // how many of the last polygons

/// The one list of keys, walked by the writer (const plan) and by the reader.
template <class PlanOrConst, class Visitor>
void each_value(PlanOrConst& plan, Visitor&& visit) {
  each_field_value(plan.field, visit);
  visit("machine.name", plan.machine.name);
  visit("machine.width_m", plan.machine.width_m);
  visit("machine.radius_m", plan.machine.radius_m);
  visit("machine.min_length_m", plan.machine.min_length_m);
  visit("objective.overlap", plan.objective.overlap);
  visit("objective.uncovered", plan.objective.uncovered);
  visit("objective.turn", plan.objective.turn);
  visit("objective.stop", plan.objective.stop);
  visit("settings.strategy", plan.settings.strategy);
  visit("settings.end_rule", plan.settings.end_rule);
  visit("settings.boundary", plan.settings.boundary);
  visit("settings.cell_direction", plan.settings.cell_direction);
  visit("settings.direction_tolerance", plan.settings.direction_tolerance);
  visit("settings.merge_threshold", plan.settings.merge_threshold);
  visit("settings.decomposition_threshold", plan.settings.decomposition_threshold);
  visit("settings.short_edge_m", plan.settings.short_edge_m);
  visit("settings.small_cell_m2", plan.settings.small_cell_m2);
  visit("settings.avoid", plan.settings.avoid);
  visit("settings.avoid_threshold_m", plan.settings.avoid_threshold_m);
  visit("settings.clearance_m", plan.settings.clearance_m);
  visit("tally.worked_m2", plan.tally.worked_m2);
  visit("tally.overlap_m2", plan.tally.overlap_m2);
  visit("tally.uncovered_m2", plan.tally.uncovered_m2);
  visit("tally.track_length_m", plan.tally.track_length_m);
  visit("tally.pieces", plan.tally.pieces);
  visit("tally.crossings", plan.tally.crossings);
  visit("tally.turns", plan.tally.turns);
  visit("tally.stops", plan.tally.stops);
  visit("cost", plan.cost);
  visit("proof.bound", plan.proof.bound);
  visit("proof.one_direction_cost", plan.proof.one_direction_cost);
  visit("proof.one_direction_bound", plan.proof.one_direction_bound);
  visit("directions_tried", plan.directions_tried);
  visit("warnings", plan.warnings);
}

/// The keys that came with headlands and curved tracks.
template <class PlanOrConst, class Visitor>
void each_value_since_headlands(PlanOrConst& plan, Visitor&& visit) {
  visit("settings.headlands", plan.settings.headlands);
  visit("settings.obstacle_headlands", plan.settings.obstacle_headlands);
  visit("settings.shape", plan.settings.shape);
  visit("settings.guide", plan.settings.guide);
  visit("headland.obstacle_passes", plan.headland.obstacle_passes);
  visit("headland.worked_m2", plan.headland.worked_m2);
  visit("headland.overlap_m2", plan.headland.overlap_m2);
  visit("headland.uncovered_m2", plan.headland.uncovered_m2);
}

/// The keys that came with figures of tracks and headland passes together.
template <class PlanOrConst, class Visitor>
void each_value_since_whole_figures(PlanOrConst& plan, Visitor&& visit) {
  visit("objective.subfield", plan.objective.subfield);
  visit("tally.subfields", plan.tally.subfields);
  visit("track_tally.worked_m2", plan.track_tally.worked_m2);
  visit("track_tally.overlap_m2", plan.track_tally.overlap_m2);
  visit("track_tally.uncovered_m2", plan.track_tally.uncovered_m2);
}

constexpr const char* kCutShort = "proof.cut_short";
constexpr const char* kPricesBound = "proof.prices_bound";  // only where there are prices of the land
constexpr const char* kStopRule = "stop_rule";  // only of plans whose stops are ends without a way off
constexpr const char* kNoWayOff = "no_way_off";

/// Settings that few plans have: a key is written only where the value is not the default one.
template <class PlanOrConst, class Visitor>
void each_turning_value(PlanOrConst& plan, Visitor&& visit) {
  visit("settings.turns", plan.settings.turns);
  visit("settings.headland_rule", plan.settings.headland_rule);
  visit("settings.obstacle_headland_rule", plan.settings.obstacle_headland_rule);
  visit("settings.skip", plan.settings.skip);
  visit("settings.turn_room_m", plan.settings.turn_room_m);
  visit("settings.towing_error_m", plan.settings.towing_error_m);
}

/// The values of `plan` that are not those of `other`, by their keys.
Metadata that_differ(const Metadata& of, const Metadata& other) {
  Metadata out;
  for (const auto& [key, value] : of)
    if (const auto found = other.find(key); found == other.end() || found->second != value) out[key] = value;
  return out;
}

/// Counts and lengths are the same for tracks alone; the areas are read or, in older files, are all there is.
void complete_track_tally(int version, Plan& plan) {
  Tally of_tracks = plan.tally;
  if (version >= kVersionWithWholeFigures) {
    of_tracks.worked_m2 = plan.track_tally.worked_m2;
    of_tracks.overlap_m2 = plan.track_tally.overlap_m2;
    of_tracks.uncovered_m2 = plan.track_tally.uncovered_m2;
  }
  plan.track_tally = of_tracks;
}

void write_turning_values(const Plan& plan, Metadata& out) {
  Metadata values, defaults;
  const Plan plain;
  each_turning_value(plan, PlanKeyWriter(values, {}));
  each_turning_value(plain, PlanKeyWriter(defaults, {}));
  out.merge(that_differ(values, defaults));
}

/// Is there a line that some of the tracks follow and others do not?
bool has_own_lines(const Plan& plan) { return !common_reference(plan) && !references(plan).empty(); }

void write_references(const Plan& plan, const PlanKeyWriter& writer) {
  writer(kReference, common_reference(plan).value_or(Path{}));
  if (!has_own_lines(plan)) return;
  std::vector<Path> lines;
  for (const Subfield& subfield : plan.subfields) lines.push_back(subfield.reference);
  writer(kReferences, lines);
}

bool has_given_subfields(const Plan& plan) {
  return std::any_of(plan.subfields.begin(), plan.subfields.end(),
                     [](const Subfield& subfield) { return !subfield.given_by.empty(); });
}

void write_given_land(const Plan& plan, const PlanKeyWriter& writer) {
  if (plan.left_out > 0) writer(kLeftOut, static_cast<int>(plan.left_out));
  if (!has_given_subfields(plan)) return;
  std::vector<std::string> origins;
  for (const Subfield& subfield : plan.subfields) origins.push_back(subfield.given_by);
  writer(kGivenBy, origins);
}

Aim read_aim(const PlanKeyReader& reader) {
  const auto aim = aim_named(reader.text(kAim));
  if (!aim) throw reader.wrong(kAim, "cost or whole_cost");
  return *aim;
}

void write_edge_passes(const Plan& plan, const PlanKeyWriter& writer) {
  if (!plan.settings.headland_edges.empty()) writer(kHeadlandEdges, plan.settings.headland_edges);
  if (!plan.headland.edge_passes.empty()) writer(kEdgePasses, plan.headland.edge_passes);
}

int version_for(const Plan& plan) {
  if (has_route(plan)) return kVersionWithRoute;
  if (plan.machine.turning != Turning{} || !plan.settings.headland_edges.empty() ||
      !plan.headland.edge_passes.empty() || !plan.turns.empty())
    return kVersionWithTurning;
  if (has_given_subfields(plan) || plan.left_out > 0 || (!plan.worked.empty() && !is_repair(plan)))
    return kVersionWithGivenLand;
  return has_own_lines(plan) ? kVersionWithOwnLines : kVersionWithSearchEnd;
}

}  // namespace

Metadata metadata_of(const Plan& plan) {
  Metadata out;
  const PlanKeyWriter writer(out, offset_of(plan.field.frame));
  each_value(plan, writer);
  each_value_since_headlands(plan, writer);
  each_value_since_whole_figures(plan, writer);
  writer(kCutShort, plan.proof.cut_short);
  if (!plan.proof.prices.cells.empty()) writer(kPricesBound, plan.proof.prices.bound);
  out[kInputCrsKey] = plan.field.source.input_crs;
  writer(kTracks, plan.settings.tracks);
  if (plan.settings.avoid_room_m >= 0) writer(kAvoidRoom, plan.settings.avoid_room_m);
  writer(kAbAnchor, anchor_of(plan.settings));
  writer(kHeadlandConstruction, plan.headland.construction);
  if (is_of_lines(plan)) writer(kOrigin, plan.origin);
  write_turning_values(plan, out);
  if (has_route(plan)) write_route_values(plan, out);
  if (plan.stop_rule == StopRule::kNoWayOff) out[kStopRule] = kNoWayOff;
  write_references(plan, writer);
  write_given_land(plan, writer);
  write_machine_values(plan.machine, writer);
  if (plan.settings.aim != Aim::kCost) writer(kAim, std::string(name(plan.settings.aim)));
  write_edge_passes(plan, writer);
  out["format"] = kFormat;
  out["format_version"] = std::to_string(version_for(plan));
  out[kKind] = is_repair(plan) ? kRepair : "plan";
  leave_folders_out(out);
  // The kinds that no setting changes are written all the same: the file explains itself.
  out["edges.exterior"] = name(plan.settings.boundary);
  out["edges.obstacles"] = name(EdgeKind::kHard);
  out["edges.subfield_borders"] = name(EdgeKind::kSoft);
  return out;
}

int apply_metadata(const Metadata& metadata, const std::filesystem::path& file, Plan& plan) {
  PlanKeyReader reader(metadata, file, kPlanFile);
  if (reader.text("format") != kFormat) throw reader.wrong("format", "'tramline plan'");
  int version = 0;
  reader("format_version", version);
  if (version < kOldestVersion || version > kNewestVersion)
    throw reader.wrong("format_version", "from 2 to 10: read it with the tramline that wrote it");
  each_value(plan, reader);
  reader.shift_by(offset_of(plan.field.frame));
  if (version >= kVersionWithHeadlands) each_value_since_headlands(plan, reader);
  if (version >= kVersionWithWholeFigures) {
    each_value_since_whole_figures(plan, reader);
  } else {
    plan.objective.subfield = 0;  // it had no price
    plan.figures = PlanFigures::kTracks;
  }
  if (version >= kVersionWithTurning) apply_turning(metadata, reader, plan.machine);
  if (metadata.contains(kAim)) plan.settings.aim = read_aim(reader);
  apply_rates(metadata, reader, plan.machine);
  if (version >= kVersionWithSearchEnd) reader(kCutShort, plan.proof.cut_short);
  if (metadata.contains(kPricesBound)) reader(kPricesBound, plan.proof.prices.bound);
  complete_track_tally(version, plan);
  // Files from before there were these keys are as good plans.
  if (metadata.contains(kInputCrsKey)) plan.field.source.input_crs = reader.text(kInputCrsKey);
  if (metadata.contains(kTracks)) reader(kTracks, plan.settings.tracks);
  if (metadata.contains(kAvoidRoom)) reader(kAvoidRoom, plan.settings.avoid_room_m);
  plan.settings.ab_anchor = AbAnchor::kLine;
  if (metadata.contains(kAbAnchor)) reader(kAbAnchor, plan.settings.ab_anchor);
  if (metadata.contains(kHeadlandConstruction)) reader(kHeadlandConstruction, plan.headland.construction);
  if (metadata.contains(kOrigin)) reader(kOrigin, plan.origin);
  PresentKeys present(metadata, reader);
  each_turning_value(plan, present);
  if (version >= kVersionWithRoute) apply_route_values(metadata, file, plan);
  plan.stop_rule = metadata.contains(kStopRule) ? StopRule::kNoWayOff : StopRule::kTouching;
  if (metadata.contains(kHeadlandEdges)) reader(kHeadlandEdges, plan.settings.headland_edges);
  if (metadata.contains(kEdgePasses)) reader(kEdgePasses, plan.headland.edge_passes);
  return version;
}

void apply_references(const Metadata& metadata, const std::filesystem::path& file, int version, Plan& plan) {
  if (version < kVersionWithHeadlands) return;
  PlanKeyReader reader(metadata, file, kPlanFile);
  reader.shift_by(offset_of(plan.field.frame));
  Path common;
  reader(kReference, common);
  for (Subfield& subfield : plan.subfields) subfield.reference = common;
  if (!metadata.contains(kReferences)) {
    if (version == kVersionWithOwnLines) throw reader.wrong(kReferences, "a path for each subfield");
    return;
  }
  std::vector<Path> own;
  reader(kReferences, own);
  if (own.size() != plan.subfields.size())
    throw reader.wrong(kReferences, "a path, which may be empty, for each subfield");
  for (std::size_t i = 0; i < own.size(); ++i) plan.subfields[i].reference = std::move(own[i]);
}

void apply_given_land(const Metadata& metadata, const std::filesystem::path& file, Plan& plan) {
  PlanKeyReader reader(metadata, file, kPlanFile);
  if (metadata.contains(kLeftOut)) {
    int count = 0;
    reader(kLeftOut, count);
    if (count < 0 || count > std::ssize(plan.given_up))
      throw reader.wrong(kLeftOut, "at most the number of polygons given up");
    plan.left_out = static_cast<std::size_t>(count);
  }
  if (!metadata.contains(kGivenBy)) return;
  std::vector<std::string> origins;
  reader(kGivenBy, origins);
  if (origins.size() != plan.subfields.size())
    throw reader.wrong(kGivenBy, "a text, which may be empty, for each subfield");
  for (std::size_t i = 0; i < origins.size(); ++i) plan.subfields[i].given_by = std::move(origins[i]);
}

bool is_repair(const Metadata& metadata, int version) {
  const auto kind = metadata.find(kKind);
  return version == kVersionWithRepairs || (kind != metadata.end() && kind->second == kRepair);
}

}  // namespace tramline::io
