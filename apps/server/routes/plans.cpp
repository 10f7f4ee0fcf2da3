// Plans that are kept, their layers and files.

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string>

#include "report/plan_report.h"
#include "server/http/packed.h"
#include "server/http/page_words.h"
#include "server/http/shape_detail.h"
#include "server/input/json_input.h"
#include "server/map/detour_layer.h"
#include "server/map/headland_sides.h"
#include "server/map/outside_layer.h"
#include "server/map/plan_layer_list.h"
#include "server/map/shown_place.h"
#include "server/routes/routes.h"
#include "server/store/shape_key.h"
#include "tramline/geometry/error.h"
#include "tramline/io/export/layer_geojson.h"
#include "tramline/model/rate_values.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

/// Nothing of a field would be left of shapes that deviate more.
constexpr double kCoarsest_m = 100;

ordered_json route_of(const KeptPlan& plan) {
  if (!plan.route) return {};
  return {{"hours", plan.route->hours}, {"litres", plan.route->litres}, {"euros", plan.route->euros}};
}

ordered_json listed(const KeptPlan& plan) {
  return {{"id", plan.id},
          {"name", plan.name},
          {"field", plan.field},
          {"created", plan.created},
          {"cost", plan.cost},
          {"tracks", plan.tally.pieces},
          {"turns", plan.tally.turns},
          {"stops", plan.tally.stops},
          {"further_subfields", further_subfields(plan.tally)},
          {"overlap_m2", plan.tally.overlap_m2},
          {"uncovered_m2", plan.tally.uncovered_m2},
          {"width_m", plan.width_m},
          {"kind", plan.kind},
          {"draft", plan.draft},
          {"route", route_of(plan)}};
}

/// Whether the field has been changed since: by its shape, and where the plan does not say of which shape it
/// is, by time. Not of fields that are gone.
bool of_earlier_shape(const App& app, const KeptPlan& plan) {
  const KeptFieldPtr field = app.fields.find(plan.field);
  if (field == nullptr) return false;
  return plan.shape.empty() ? plan.created < field->reshaped : plan.shape != shape_key(field->field);
}

ordered_json entry_of(const App& app, const KeptPlan& plan) {
  ordered_json out = listed(plan);
  out["earlier_shape"] = of_earlier_shape(app, plan);
  return out;
}

ordered_json summary_of(const Plan& plan, const PlanNotes& notes) {
  ordered_json out = app::plan_json(plan, notes.skipped, notes.seconds);
  out["outside_m2"] = area(land_outside(plan));
  return out;
}

ordered_json in_full(const App& app, const KeptPlan& kept, const OpenedPlan& opened) {
  const Plan& plan = opened.plan;
  return {{"id", kept.id},
          {"name", kept.name},
          {"field", kept.field},
          {"created", kept.created},
          {"kind", kept.kind},
          {"draft", kept.draft},
          {"summary", summary_in_page_words(summary_of(plan, opened.notes))},
          {"explain", opened.notes.explain},
          {"asked", opened.notes.asked},
          {"earlier_shape", of_earlier_shape(app, kept)},
          {"idle_fuel_share", kIdleFuelShare},
          {"headland_sides", headland_sides(plan)},
          {"bbox", ShownPlace(plan.field.frame).bbox(bounds(plan.field.outer))}};
}

std::string layer_of(App& app, const Call& call) {
  const std::string& layer = call.part("layer");
  const KeptPlan kept = app.plans.get(call.part("plan"));
  const double detail_m = detail_in(call, kCoarsest_m);
  if (layer == kDetourLayer) return detour_geojson(app.plans.open(kept.id)->plan, detail_m).dump();
  if (layer == kOutsideLayer) return outside_geojson(app.plans.open(kept.id)->plan, detail_m).dump();
  return while_kept([&] { app.plans.get(kept.id); },
                    [&] { return io::layer_geojson(app.plans.file(kept.id), kept.frame, layer, detail_m); });
}

}  // namespace

void add_plan_routes(Router& router, App& app) {
  router.get(api("/plans"), [&app](const Call& call, httplib::Response& response) {
    ordered_json out = ordered_json::array();
    for (const KeptPlan& plan : app.plans.list(call.query("field"))) out.push_back(entry_of(app, plan));
    answer(response, out);
  });
  router.get(api("/plans/{plan}"), [&app](const Call& call, httplib::Response& response) {
    const KeptPlan kept = app.plans.get(call.part("plan"));
    answer(response, in_full(app, kept, *app.plans.open(kept.id)));
  });
  router.patch(api("/plans/{plan}"), [&app](const Call& call, httplib::Response& response) {
    const ordered_json json = call.json();
    const JsonInput input(json, "", {"name", "draft"});
    if (input.flag_if("draft").value_or(false))
      throw bad_input("a kept plan cannot become a draft; delete it instead");
    const std::string name = name_of(input, "name");
    if (input.has("draft") && !input.has("name"))
      return answer(response, entry_of(app, app.plans.keep(call.part("plan"))));
    if (name.empty()) throw bad_input("give the plan a name");
    answer(response, entry_of(app, app.plans.rename(call.part("plan"), name)));
  });
  router.remove(api("/plans/{plan}"), [&app](const Call& call, httplib::Response& response) {
    app.plans.remove(call.part("plan"));
    answer(response, {{"deleted", call.part("plan")}});
  });
  router.get(api("/plans/{plan}/layers"), [&app](const Call& call, httplib::Response& response) {
    answer(response, layer_list(app.plans.open(call.part("plan"))->plan));
  });
  router.get(api("/plans/{plan}/layers/{layer}"), [&app](const Call& call, httplib::Response& response) {
    send_geojson(call.request(), response, layer_of(app, call));
  });
}

}  // namespace tramline::server
