#include "report/evaluate_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/report_parts.h"
#include "tramline/geodesy/field_projection.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kGapsInJson = 100;
constexpr std::size_t kGapsInTable = 12;

bool has_field(const Coverage& coverage) { return !coverage.field.empty(); }
FieldKnown field_known(const Coverage& coverage) {
  return has_field(coverage) ? FieldKnown::kYes : FieldKnown::kNo;
}
double field_m2(const Coverage& coverage) { return area(coverage.field); }

double repeated_rate(const CoverageAreas& areas) {
  return areas.covered_m2 > 0 ? areas.repeated_m2 / areas.covered_m2 : 0;
}
double worked_hours(const Coverage& coverage) { return coverage.worked_s / 3600; }
double ha_per_hour(const Coverage& coverage) {
  return coverage.areas.covered_m2 / 1e4 / worked_hours(coverage);
}

/// Null where there is no number.
ordered_json of_field(const Coverage& coverage, double value) {
  return has_field(coverage) ? number_json(value) : ordered_json();
}

/// Coordinates as the input has them: longitude and latitude, or plain metres.
Point in_input(const LocalFrame& frame, const std::optional<FrameProjection>& projection, Point local) {
  return projection ? projection->to_lonlat(local)
                    : Point{local.x + frame.origin_x_m, local.y + frame.origin_y_m};
}

std::optional<FrameProjection> projection_of(const LocalFrame& frame) {
  return frame.geodetic ? std::optional<FrameProjection>(frame) : std::nullopt;
}

ordered_json gaps_json(const Coverage& coverage) {
  const std::optional<FrameProjection> projection = projection_of(coverage.frame);
  ordered_json out = ordered_json::array();
  for (const Gap& gap : coverage.gaps) {
    if (out.size() == kGapsInJson) break;
    const Point at = in_input(coverage.frame, projection, gap.centre);
    out.push_back({{"number", gap.number},
                   {"area_m2", gap.area_m2},
                   {"widest_m", number_json(gap.widest_m)},
                   {"centre", {at.x, at.y}}});
  }
  return out;
}

ordered_json skipped_list(const SkippedRecords& skipped) {
  ordered_json out = ordered_json::array();
  for (const SkippedRecord& record : skipped.listed)
    out.push_back({{"record", record.record}, {"why", record.why}});
  return out;
}

ordered_json slices_json(const Coverage& coverage) {
  ordered_json out = ordered_json::array();
  for (const CoverageSlice& slice : coverage.slices) {
    ordered_json& one = out.emplace_back();
    one = {{"fixes", slice.fixes},
           {"covered_m2", slice.areas.covered_m2},
           {"repeated_m2", slice.areas.repeated_m2},
           {"missed_m2", of_field(coverage, slice.areas.missed_m2)},
           {"not_recorded_m2", slice.areas.not_recorded_m2},
           {"covered_rings", slice.covered_rings},
           {"missed_regions", slice.missed_regions}};
    if (slice.meshes) one["meshes"] = meshes_json(*slice.meshes, field_known(coverage));
    one["seconds"] = slice.seconds;
  }
  return out;
}

ordered_json headings_json(const Coverage& coverage) {
  const HeadingContradiction& found = *coverage.headings;
  const Point at = in_input(coverage.frame, projection_of(coverage.frame), found.at);
  return {{"read_as", found.read_as},
          {"steps", found.steps},
          {"off", found.off},
          {"share", found.share()},
          {"first", {{"record", found.record}, {"time_s", number_json(found.time_s)}, {"at", {at.x, at.y}}}},
          {"better", found.better},
          {"better_off", found.better_off}};
}

std::string mesh_row(const Coverage& coverage) {
  if (!coverage.meshes) return "";
  const auto [side_m, covered, missed] = *coverage.meshes;
  std::string out = fmt::format("meshes       {} along covered land (at most {})", covered.now, covered.most);
  if (has_field(coverage)) out += fmt::format(", {} along missed land (at most {})", missed.now, missed.most);
  return out + fmt::format(", of {:g} m\n", side_m);
}

ordered_json tally_json(const PlanTally& plan, const CoverageAreas& areas) {
  return {{"file", plan.plan},
          {"land_m2", plan.land_m2},
          {"body_m2", plan.body_m2},
          {"uncovered_m2", plan.tally.uncovered_m2},
          {"overlap_m2", plan.tally.overlap_m2},
          {"driven_uncovered_m2", areas.missed_m2},
          {"driven_overlap_m2", areas.gross_m2 - areas.covered_inside_m2}};
}

/// Null where the plan was not followed: how far a drive is off a plan that it did not keep to says nothing.
ordered_json if_followed(const coverage::Deviation& deviation, double value_m) {
  return deviation.followed() ? number_json(value_m) : ordered_json();
}

ordered_json compared_json(const PlanAndDone& compared) {
  const coverage::Deviation& deviation = compared.deviation;
  return {{"file", compared.plan},
          {"planned_m2", compared.planned_m2},
          {"planned_missed_m2", compared.planned_missed_m2},
          {"planned_not_recorded_m2", compared.planned_not_recorded_m2},
          {"unplanned_m2", compared.unplanned_m2},
          {"followed", deviation.followed()},
          {"followed_share", deviation.followed_share()},
          {"along_tracks_m", deviation.along_m},
          {"beside_tracks_m", deviation.beside_m},
          {"median_distance_m", number_json(deviation.median_distance_m)},
          {"median_angle_deg", number_json(deviation.median_angle_deg)},
          {"deviation_mean_m", if_followed(deviation, deviation.mean_m)},
          {"deviation_p95_m", if_followed(deviation, deviation.p95_m)},
          {"deviation_most_m", if_followed(deviation, deviation.most_m)}};
}

std::string share(const Coverage& coverage, double part_m2) {
  return has_field(coverage) ? fmt::format(" ({:.2f} % of the field)", 100 * part_m2 / field_m2(coverage))
                             : "";
}

std::string drive_rows(const Coverage& coverage) {
  std::string out;
  if (has_field(coverage))
    out += fmt::format("field        {}, {:.4f} ha\n", coverage.field_id, field_m2(coverage) / 1e4);
  if (!coverage.log.empty())
    out += fmt::format("log          {}: {} fixes, {} used\n", coverage.log, coverage.fixes,
                       coverage.fixes_used);
  out += fmt::format(
      "work         {} runs, {}{}\n", coverage.runs,
      std::isfinite(coverage.width_m) ? fmt::format("{:g} m wide", coverage.width_m) : "width not known",
      std::isfinite(coverage.worked_s) && coverage.worked_s > 0
          ? fmt::format(", {:.2f} h, {:.2f} ha/h", worked_hours(coverage), ha_per_hour(coverage))
          : "");
  return out;
}

ordered_json machine_json(const MachineCounters& counters) {
  return {{"area_m2", number_json(counters.area_m2)},
          {"distance_m", number_json(counters.distance_m)},
          {"hours", number_json(counters.seconds / 3600)}};
}

/// What the machine counted itself, beside what was evaluated.
std::string machine_row(const Coverage& coverage) {
  const MachineCounters& counters = coverage.counters;
  if (!counters.any()) return "";
  std::vector<std::string> parts;
  if (std::isfinite(counters.area_m2)) parts.push_back(fmt::format("{:.1f} m²", counters.area_m2));
  if (std::isfinite(counters.distance_m))
    parts.push_back(fmt::format("{:.2f} km", counters.distance_m / 1000));
  if (std::isfinite(counters.seconds)) parts.push_back(fmt::format("{:.2f} h", counters.seconds / 3600));
  return fmt::format("counter      {} by the machine's own count\n", fmt::join(parts, ", "));
}

std::string area_rows(const Evaluation& evaluation) {
  const Coverage& coverage = evaluation.coverage;
  const CoverageAreas& areas = coverage.areas;
  std::string out;
  out +=
      fmt::format("covered      {:.1f} m²{}\n", areas.covered_m2, share(coverage, areas.covered_inside_m2));
  out += machine_row(coverage);
  if (has_field(coverage))
    out += fmt::format("outside      {:.1f} m² of that, beyond the field\n", areas.outside_m2);
  out += fmt::format(
      "repeated     {:.1f} m², {:.2f} % of what is covered{}\n", areas.repeated_m2,
      100 * repeated_rate(areas),
      evaluation.repeat == coverage::RepeatRule::kStrict || coverage.meshes ? ", slivers included" : "");
  if (areas.sliver_m2 > 0)
    out += fmt::format("slivers      {:.1f} m² worked twice on the inside of curves\n", areas.sliver_m2);
  if (has_field(coverage))
    out += fmt::format("missed       {:.1f} m²{} in {} places\n", areas.missed_m2,
                       share(coverage, areas.missed_m2), coverage.gaps.size());
  if (areas.not_recorded_m2 > 0)
    out += fmt::format(
        "not recorded {:.1f} m²{}: the machine may have worked there while the log has no fixes\n",
        areas.not_recorded_m2, share(coverage, areas.not_recorded_m2));
  return out;
}

std::string gap_rows(const Coverage& coverage) {
  const std::optional<FrameProjection> projection = projection_of(coverage.frame);
  std::string out;
  for (std::size_t i = 0; i < std::min(coverage.gaps.size(), kGapsInTable); ++i) {
    const Gap& gap = coverage.gaps[i];
    const Point at = in_input(coverage.frame, projection, gap.centre);
    const std::string widest =
        std::isfinite(gap.widest_m) ? fmt::format("up to {:.2f} m wide", gap.widest_m) : "width not known";
    out += fmt::format("  gap {:<6} {:.1f} m², {}, at ({:.9g}, {:.9g})\n", gap.number, gap.area_m2, widest,
                       at.x, at.y);
  }
  if (coverage.gaps.size() > kGapsInTable)
    out += fmt::format("  and {} smaller ones\n", coverage.gaps.size() - kGapsInTable);
  return out;
}

std::string deviation_row(const coverage::Deviation& deviation) {
  if (deviation.followed())
    return fmt::format(
        "deviation    {:.2f} m on average, 95 % within {:.2f} m, at most {:.2f} m, over {:.0f} m along "
        "tracks; "
        "{:.0f} m beside them\n",
        deviation.mean_m, deviation.p95_m, deviation.most_m, deviation.along_m, deviation.beside_m);
  if (!(deviation.along_m + deviation.beside_m > 0)) return "";
  std::string how;
  if (deviation.median_angle_deg > coverage::kAlongTrack.degrees())
    how = fmt::format("; its direction differs by {:.0f}° from that of the nearest track (median)",
                      deviation.median_angle_deg);
  else if (std::isfinite(deviation.median_distance_m))
    how = fmt::format("; {:.2f} m from the nearest track (median)", deviation.median_distance_m);
  return fmt::format(
      "deviation    The drive did not follow the plan: {:.0f} of {:.0f} m at work lie along its tracks{}\n",
      deviation.along_m, deviation.along_m + deviation.beside_m, how);
}

std::string plan_rows(const Evaluation& evaluation) {
  const CoverageAreas& areas = evaluation.coverage.areas;
  std::string out;
  if (evaluation.tally)
    out += fmt::format(
        "plan         its tally: uncovered {:.1f} m², overlap {:.1f} m²; driven: {:.1f} m², {:.1f} m²\n",
        evaluation.tally->tally.uncovered_m2, evaluation.tally->tally.overlap_m2, areas.missed_m2,
        areas.gross_m2 - areas.covered_inside_m2);
  if (!evaluation.compared) return out;
  const PlanAndDone& compared = *evaluation.compared;
  out += fmt::format("plan         {:.1f} m² planned; {:.1f} m² of it not worked, {:.1f} m² worked besides\n",
                     compared.planned_m2, compared.planned_missed_m2, compared.unplanned_m2);
  if (compared.planned_not_recorded_m2 > 0)
    out += fmt::format("             {:.1f} m² of it not recorded\n", compared.planned_not_recorded_m2);
  return out + deviation_row(compared.deviation);
}

std::string slice_rows(const Coverage& coverage) {
  if (coverage.slices.empty()) return "";
  const bool meshes = coverage.slices.front().meshes.has_value();
  std::string out =
      fmt::format("{:>9} {:>13} {:>13} {:>13} {:>6} {:>8}{}  {}\n", "fixes", "covered m²", "repeated m²",
                  "missed m²", "rings", "regions", meshes ? "  meshes: covered missed" : "", "time so far");
  for (const CoverageSlice& slice : coverage.slices)
    out += fmt::format(
        "{:>9} {:>12.2f} {:>12.2f} {:>12.2f} {:>6} {:>8}{}  {:.2f} ms\n", slice.fixes, slice.areas.covered_m2,
        slice.areas.repeated_m2, slice.areas.missed_m2, slice.covered_rings, slice.missed_regions,
        slice.meshes ? fmt::format("{:>17} {:>6}", slice.meshes->covered.most, slice.meshes->missed.most)
                     : "",
        1e3 * slice.seconds);
  return out;
}

std::string remark_rows(const Coverage& coverage) {
  constexpr std::size_t kShown = 5;
  std::string out;
  for (std::size_t i = 0; i < std::min(kShown, coverage.skipped.listed.size()); ++i)
    out += fmt::format("skipped      record {}: {}\n", coverage.skipped.listed[i].record,
                       coverage.skipped.listed[i].why);
  if (coverage.skipped.count > kShown)
    out += fmt::format("             and {} more records\n", coverage.skipped.count - kShown);
  out += note_rows(coverage.warnings);
  return out;
}

}  // namespace

ordered_json meshes_json(const Meshes& meshes, FieldKnown field) {
  const auto count = [](const MeshCount& meshes_of) {
    return ordered_json{{"now", meshes_of.now}, {"most", meshes_of.most}};
  };
  return {{"side_m", meshes.side_m},
          {"covered", count(meshes.covered)},
          {"missed", field == FieldKnown::kYes ? count(meshes.missed) : ordered_json()}};
}

ordered_json evaluation_json(const Evaluation& evaluation) {
  const Coverage& coverage = evaluation.coverage;
  const CoverageAreas& areas = coverage.areas;
  ordered_json out;
  out["field_id"] = has_field(coverage) ? ordered_json(coverage.field_id) : ordered_json();
  out["field_area_m2"] = of_field(coverage, field_m2(coverage));
  out["log"] = coverage.log.empty() ? ordered_json() : ordered_json(coverage.log);
  out["width_m"] = number_json(coverage.width_m);
  out["fixes"] = coverage.fixes;
  out["fixes_used"] = coverage.fixes_used;
  out["skipped"] = skipped_list(coverage.skipped);
  out["skipped_count"] = coverage.skipped.count;
  out["runs"] = coverage.runs;
  out["gross_m2"] = areas.gross_m2;
  out["covered_m2"] = areas.covered_m2;
  out["covered_inside_m2"] = of_field(coverage, areas.covered_inside_m2);
  out["outside_m2"] = of_field(coverage, areas.outside_m2);
  out["repeated_m2"] = areas.repeated_m2;
  out["sliver_m2"] = areas.sliver_m2;
  out["repeated_rate"] = repeated_rate(areas);
  out["missed_m2"] = of_field(coverage, areas.missed_m2);
  out["not_recorded_m2"] = areas.not_recorded_m2;
  out["missed_regions"] = has_field(coverage) ? ordered_json(coverage.gaps.size()) : ordered_json();
  out["worked_hours"] = number_json(worked_hours(coverage));
  out["ha_per_hour"] = number_json(ha_per_hour(coverage));
  if (coverage.counters.any()) out["machine"] = machine_json(coverage.counters);
  out["engine"] = coverage.engine;
  if (coverage.meshes) out["meshes"] = meshes_json(*coverage.meshes, field_known(coverage));
  out["worked_once_m2"] = number_json(areas.worked_times_m2[1]);
  out["worked_twice_m2"] = number_json(areas.worked_times_m2[2]);
  out["worked_more_m2"] = number_json(areas.worked_times_m2[3]);
  if (has_field(coverage)) out["gaps"] = gaps_json(coverage);
  if (!coverage.slices.empty()) out["slices"] = slices_json(coverage);
  if (!evaluation.with.empty()) out["with"] = evaluation.with;
  if (evaluation.tally) out["plan"] = tally_json(*evaluation.tally, areas);
  if (evaluation.compared) out["plan"] = compared_json(*evaluation.compared);
  if (coverage.headings) out["headings"] = headings_json(coverage);
  out["warnings"] = coverage.warnings;
  out["seconds"] = evaluation.seconds;
  return out;
}

std::string evaluation_table(const Evaluation& evaluation) {
  const Coverage& coverage = evaluation.coverage;
  std::string with;
  for (const std::string& plan : evaluation.with)
    with += fmt::format("with         the drive of {}, counted as done\n", plan);
  return drive_rows(coverage) + with + area_rows(evaluation) + gap_rows(coverage) + plan_rows(evaluation) +
         mesh_row(coverage) + slice_rows(coverage) +
         fmt::format("time         {:.3f} s, engine '{}'\n", evaluation.seconds, coverage.engine) +
         remark_rows(coverage);
}

}  // namespace tramline::app
