// Fields that are kept.

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "server/input/field_change.h"
#include "server/input/field_source.h"
#include "server/input/json_input.h"
#include "server/map/field_json.h"
#include "server/routes/routes.h"
#include "server/store/new_id.h"
#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

NewFields new_fields(App& app, const ordered_json& json, const std::string& name) {
  if (!json.contains("upload")) {
    const JsonInput input(json, "", {"name", "geometry", "crop"});
    return fields_drawn(input.value("geometry"), name);
  }
  const JsonInput input(
      json, "", {"upload", "fid", "layer", "crs", "name", "obstacles_upload", "obstacle_size_m", "crop"});
  FeatureChoice choice;
  choice.name = name;
  choice.fid = input.whole_if("fid");
  choice.layer = input.text_or_none("layer");
  choice.crs = input.text_or_none("crs");
  choice.obstacle_size_m = input.number_if("obstacle_size_m");
  if (input.has("obstacles_upload")) choice.obstacles = app.uploads.get(input.text("obstacles_upload"));
  const Upload upload = app.uploads.get(input.text("upload"));
  return while_kept(
      [&] {
        app.uploads.get(upload.id);
        if (choice.obstacles) app.uploads.get(choice.obstacles->id);
      },
      [&] { return fields_from(upload, choice); });
}

/// The first part of the feature, and the ids of the others, which are kept too.
ordered_json keep_new(App& app, const ordered_json& json) {
  const JsonInput any(
      json, "",
      {"upload", "fid", "layer", "crs", "name", "geometry", "obstacles_upload", "obstacle_size_m", "crop"});
  const std::string name = name_of(any, "name");
  const NewFields found = new_fields(app, json, name);
  ordered_json others = ordered_json::array();
  KeptFieldPtr first;
  for (const Field& field : found.fields) {
    const KeptFieldPtr kept = app.fields.add(field, field.id, found.skipped, name_of(any, "crop"));
    if (first == nullptr)
      first = kept;
    else
      others.push_back(kept->id);
  }
  ordered_json out = field_in_full(*first);
  out["others"] = std::move(others);
  return out;
}

std::vector<std::string> tags_in(const JsonInput& input) {
  constexpr std::size_t kMost = 20, kLongest = 40;
  std::vector<std::string> out;
  for (const ordered_json& tag : input.list("tags")) {
    if (!tag.is_string() || tag.get<std::string>().empty() || tag.get<std::string>().size() > kLongest)
      throw bad_input(fmt::format("tags has to be a list of words of at most {} letters", kLongest));
    out.push_back(tag.get<std::string>());
  }
  if (out.size() > kMost) throw bad_input(fmt::format("tags may be {} words at most", kMost));
  return out;
}

ordered_json change(App& app, const std::string& id, const ordered_json& json) {
  const JsonInput input(json, "", {"name", "add", "remove", "boundary", "crop", "tags"});
  return field_in_full(*app.fields.change(id, [&](KeptField& kept) {
    if (input.has("name")) kept.name = name_of(input, "name");
    if (kept.name.empty()) throw bad_input("give the field a name");
    if (input.has("crop")) kept.crop = name_of(input, "crop");
    if (input.has("tags")) kept.tags = tags_in(input);
    if (input.has("boundary")) kept.field = with_boundary(kept.field, input.value("boundary"));
    if (input.has("boundary") || !input.list("remove").empty() || !input.list("add").empty())
      kept.reshaped = time_now();
    kept.field = changed_field(std::move(kept.field), input.list("remove"), input.list("add"));
  }));
}

/// What the list of fields says of a field's latest plan; null where it has none.
ordered_json last_plan(const App& app, const std::string& field) {
  const std::vector<KeptPlan> plans = app.plans.list(field);
  if (plans.empty()) return {};
  const KeptPlan& last = plans.front();
  ordered_json out{{"id", last.id},
                   {"created", last.created},
                   {"width_m", last.width_m},
                   {"hours", nullptr},
                   {"euros", nullptr}};
  if (last.route) {
    out["hours"] = last.route->hours;
    out["euros"] = last.route->euros;
  }
  return out;
}

}  // namespace

void add_field_routes(Router& router, App& app) {
  router.get(api("/fields"), [&app](const Call&, httplib::Response& response) {
    ordered_json out = ordered_json::array();
    for (const KeptFieldPtr& kept : app.fields.list()) {
      ordered_json entry = field_entry(*kept);
      entry["outline"] = field_outline(*kept);
      entry["last_plan"] = last_plan(app, kept->id);
      out.push_back(std::move(entry));
    }
    answer(response, out);
  });
  router.post(api("/fields"), [&app](const Call& call, httplib::Response& response) {
    answer(response, keep_new(app, call.json()), 201);
  });
  router.get(api("/fields/{field}"), [&app](const Call& call, httplib::Response& response) {
    answer(response, field_in_full(*app.fields.get(call.part("field"))));
  });
  router.patch(api("/fields/{field}"), [&app](const Call& call, httplib::Response& response) {
    answer(response, change(app, call.part("field"), call.json()));
  });
  router.remove(api("/fields/{field}"), [&app](const Call& call, httplib::Response& response) {
    app.fields.remove(call.part("field"));
    answer(response, {{"deleted", call.part("field")}});
  });
}

}  // namespace tramline::server
