// Comparisons of plans, and the plans they lead to.

#include <fmt/format.h>

#include <charconv>

#include "report/front_report.h"
#include "server/routes/routes.h"
#include "server/store/kept_front.h"
#include "server/store/shape_key.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

ordered_json json_of(const KeptFront& front) {
  const std::vector<Objective> none;
  const app::Comparison comparison{front.field->field, front.machine, front.settings,
                                   front.found.front,  none,          front.seconds};
  ordered_json out{{"id", front.id}, {"field", front.field->id}, {"name", front.name}};
  out.update(app::compare_json(comparison, front.field->skipped));
  return out;
}

std::size_t point_in(const KeptFront& front, const std::string& word) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool known = error == std::errc{} && end == word.data() + word.size() && number >= 1 &&
                     number <= front.found.front.points.size();
  if (!known)
    throw HttpError(Fault::kNotFound, fmt::format("there is no plan {} in this comparison; it has {}", word,
                                                  front.found.front.points.size()));
  return number - 1;
}

}  // namespace

void add_front_routes(Router& router, App& app) {
  router.get(api("/fronts/{front}"), [&app](const Call& call, httplib::Response& response) {
    answer(response, json_of(*app.fronts.get(call.part("front"))));
  });
  router.post(api("/fronts/{front}/points/{point}"), [&app](const Call& call, httplib::Response& response) {
    const KeptFrontPtr front = app.fronts.get(call.part("front"));
    const std::size_t point = point_in(*front, call.part("point"));
    PlanNotes notes{fmt::format("{}, plan {}", front->name, point + 1),
                    front->field->id,
                    front->field->skipped,
                    0,
                    nullptr,
                    false,
                    front->asked,
                    shape_key(front->field->field)};
    answer(response, {{"plan", app.plans.add(plan_of(front->found, point), std::move(notes)).id}}, 201);
  });
}

}  // namespace tramline::server
