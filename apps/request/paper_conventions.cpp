#include "request/paper_conventions.h"

#include <fmt/format.h>

#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

/// Versleijen 2019: his search, ends of swaths and rule at obstacles (§2.2), the field without its headland
/// (§2.1.1), thresholds of §2.2.6, stops and subfields without a price (eq. 1). The thesis weights one factor
/// after the other; where it shows only one result, turns (table 10, table 11).
std::vector<Convention> versleijen() {
  return {{"--strategy", "sweep", [](PlanOptions& o) { o.strategy = "sweep"; }},
          {"--end-rule", "centre", [](PlanOptions& o) { o.end_rule = "centre"; }},
          {"--boundary", "soft", [](PlanOptions& o) { o.boundary = "soft"; }},
          {"--avoid", "paper", [](PlanOptions& o) { o.avoid = "paper"; }},
          {"--decomposition", "180", [](PlanOptions& o) { o.decomposition_deg = 180; }},
          {"--merge", "0", [](PlanOptions& o) { o.merge_deg = 0; }},
          {"--short-edge", "0", [](PlanOptions& o) { o.short_edge_m = 0; }},
          {"--cell-direction", "rectangle", [](PlanOptions& o) { o.cell_direction = "rectangle"; }},
          {"--headlands", "0", [](PlanOptions& o) { o.headlands = "0"; }},
          {"--obstacle-headlands", "0", [](PlanOptions& o) { o.obstacle_headlands = "0"; }},
          {"--minimise", "turns", [](PlanOptions& o) { o.minimise = "turns"; }}};
}

/// Zhou et al. 2020: tracks made one from the other with plain headland rings, straight ones from the
/// envelope, ends that leave nothing uncovered (§2.3), no detours. The number of headland passes is the
/// user's, the same for the field and each obstacle (§2.3.1).
std::vector<Convention> zhou() {
  return {{"--tracks", "paper", [](PlanOptions& o) { o.tracks = "paper"; }},
          {"--end-rule", "cover", [](PlanOptions& o) { o.end_rule = "cover"; }},
          {"--boundary", "soft", [](PlanOptions& o) { o.boundary = "soft"; }},
          {"--avoid", "cut", [](PlanOptions& o) { o.avoid = "cut"; }},
          {"--headlands", "2", [](PlanOptions& o) { o.headlands = "2"; }},
          {"--obstacle-headlands", "those of --headlands",
           [](PlanOptions& o) { o.obstacle_headlands = o.headlands; }},
          {"--min-length", "0", [](PlanOptions& o) { o.min_length_m = 0; }}};
}

}  // namespace

std::vector<Convention> conventions_like(const std::string& paper) {
  if (paper.empty()) return {};
  if (paper == "versleijen") return versleijen();
  if (paper == "zhou") return zhou();
  throw bad_input(fmt::format("--like must be versleijen or zhou, not '{}'", paper));
}

std::string conventions_text(const std::string& paper) {
  std::string out;
  for (const Convention& convention : conventions_like(paper))
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", convention.option, convention.value);
  return out;
}

}  // namespace tramline::app
