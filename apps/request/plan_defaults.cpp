#include "request/plan_defaults.h"

#include "tramline/model/plan.h"

namespace tramline::app {

bool asks_for_tracks(const PlanOptions& o) {
  return !(o.weights.empty() && o.prices.empty() && o.minimise.empty() && o.like.empty()) ||
         o.strategy == name(Strategy::kSweep) || o.tracks == name(TrackConstruction::kPaper);
}

std::vector<Convention> whole_plan_defaults(const PlanOptions& o) {
  std::vector<Convention> out{
      {"--headlands", "auto", [](PlanOptions& to) { to.headlands = "auto"; }},
      {"--obstacle-headlands", "auto", [](PlanOptions& to) { to.obstacle_headlands = "auto"; }},
      {"--boundary", "hard", [](PlanOptions& to) { to.boundary = "hard"; }}};
  if (o.ab.empty() && o.guide_file.empty())
    out.push_back({"--curved", "auto", [](PlanOptions& to) { to.curved = "auto"; }});
  if (!o.turns) out.push_back({"--route", "whole", [](PlanOptions& to) { to.route = "whole"; }});
  return out;
}

}  // namespace tramline::app
