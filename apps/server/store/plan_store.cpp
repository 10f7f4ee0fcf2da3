#include "server/store/plan_store.h"

#include <fmt/format.h>

#include <algorithm>

#include <cstdlib>
#include <system_error>
#include <utility>

#include "report/report_parts.h"
#include "server/http/http_error.h"
#include "server/store/new_id.h"
#include "server/store/remark_values.h"
#include "tramline/geometry/error.h"
#include "tramline/io/geopackage/remarks.h"
#include "tramline/io/plan/plan_layers.h"
#include "tramline/io/plan/plan_metadata.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/model/objective.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

constexpr const char* kPlans = "plans";
/// The plan on a map, the one that it is an edit of, and two that stand side by side.
constexpr std::size_t kOpenedAtOnce = 4;

ordered_json object_in(const std::string& text) {
  auto out = ordered_json::parse(text, nullptr, false);
  return out.is_object() ? out : ordered_json();
}

/// Empty where the plan has no route.
std::string figures_text(const Plan& plan) {
  if (!plan.route.planned()) return "";
  const WholeCost cost = whole_cost(plan);
  return app::json_line({{"hours", cost.time_s() / 3600}, {"litres", cost.fuel_l}, {"euros", cost.euros()}});
}

std::optional<RouteFigures> figures_in(const std::string& text) {
  const ordered_json json = object_in(text);
  if (json.is_null()) return std::nullopt;
  return RouteFigures{json.value("hours", 0.0), json.value("litres", 0.0), json.value("euros", 0.0)};
}

io::Metadata remarks_of(const std::string& created, const Plan& plan, const PlanNotes& notes) {
  return {{"name", notes.name},
          {"field", notes.field},
          {"created", created},
          {"skipped", skipped_text(notes.skipped)},
          {"seconds", fmt::format("{}", notes.seconds)},
          {"explain", app::json_line(notes.explain)},
          {"draft", notes.draft ? "yes" : ""},
          {"asked", app::json_line(notes.asked)},
          {"shape", notes.shape},
          {"route", figures_text(plan)}};
}

PlanNotes notes_in(const io::Metadata& remarks) {
  PlanNotes out{remark(remarks, "name"), remark(remarks, "field"), skipped_in(remark(remarks, "skipped")),
                std::strtod(remark(remarks, "seconds").c_str(), nullptr), nullptr};
  out.explain = object_in(remark(remarks, "explain"));
  out.asked = object_in(remark(remarks, "asked"));
  out.draft = remark(remarks, "draft") == "yes";
  out.shape = remark(remarks, "shape");
  return out;
}

}  // namespace

PlanStore::PlanStore(const StoreFolder& folder, std::vector<std::string>& warnings) : folder_(folder) {
  for (const std::string& id : folder.ids(kPlans)) {
    try {
      plans_[id] = read(id);
    } catch (const Error& error) {
      warnings.emplace_back(error.what());
    }
  }
}

KeptPlan PlanStore::read(const std::string& id) const {
  const std::filesystem::path path = folder_.file(kPlans, id);
  const io::Metadata metadata = io::read_metadata(path, io::kPlanFile);
  Plan plan;
  const int version = io::apply_metadata(metadata, path, plan);
  const io::Metadata remarks = io::remarks_in(metadata);
  KeptPlan out;
  out.id = id;
  out.name = remark(remarks, "name");
  if (out.name.empty()) out.name = plan.field.id;
  out.field = remark(remarks, "field");
  out.created = remark(remarks, "created");
  out.kind = io::is_repair(metadata, version) ? "repair" : "plan";
  out.cost = plan.cost;
  out.tally = plan.tally;
  out.width_m = plan.machine.width_m;
  out.frame = plan.field.frame;
  out.draft = remark(remarks, "draft") == "yes";
  out.route = figures_in(remark(remarks, "route"));
  out.shape = remark(remarks, "shape");
  return out;
}

KeptPlan PlanStore::write(const std::string& id, const std::string& created, OpenedPlan opened) {
  io::write_plan(opened.plan, folder_.file(kPlans, id), remarks_of(created, opened.plan, opened.notes));
  KeptPlan out = read(id);
  auto kept = std::make_shared<const OpenedPlan>(std::move(opened));
  const std::lock_guard lock(mutex_);
  plans_[id] = out;
  ++writes_;
  put_first(id, std::move(kept));
  return out;
}

KeptPlan PlanStore::add(Plan plan, PlanNotes notes) {
  const bool is_edit = notes.asked.is_object() && notes.asked.contains("edit_of");
  const std::string edited = is_edit ? notes.asked["edit_of"].get<std::string>() : "";
  KeptPlan out = write(new_id(), time_now(), {std::move(plan), std::move(notes)});
  if (out.draft) drop_other_drafts(out, edited);
  return out;
}

/// Several where a server was killed between keeping one and dropping the one before.
void PlanStore::drop_other_drafts(const KeptPlan& newest, const std::string& edited) {
  const std::lock_guard one_at_a_time(changing_);
  const std::lock_guard lock(mutex_);
  if (!plans_.contains(newest.id)) return;  // of two at the same time, one stays
  std::error_code ignored;
  std::erase_if(plans_, [&](const auto& entry) {
    const KeptPlan& plan = entry.second;
    if (!plan.draft || plan.field != newest.field || plan.id == newest.id || plan.id == edited) return false;
    std::filesystem::remove(folder_.file(kPlans, plan.id), ignored);
    return true;
  });
}

std::vector<KeptPlan> PlanStore::list(const std::string& field) const {
  const std::lock_guard lock(mutex_);
  std::vector<KeptPlan> out;
  std::for_each(plans_.rbegin(), plans_.rend(), [&](const auto& entry) {
    if (field.empty() || entry.second.field == field) out.push_back(entry.second);
  });
  return out;
}

KeptPlan PlanStore::get(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto found = plans_.find(id);
  if (found == plans_.end()) throw not_found("plan", id);
  return found->second;
}

std::filesystem::path PlanStore::file(const std::string& id) const {
  return folder_.file(kPlans, get(id).id);
}

io::PlanFile PlanStore::on_disk(const std::string& id) const {
  return while_kept([&] { get(id); }, [&] { return io::read_plan_file(file(id)); });
}

/// Null where it is not in memory.
OpenedPlanPtr PlanStore::opened_before(const std::string& id) const {
  const auto found = std::ranges::find(opened_, id, &Opened::id);
  return found == opened_.end() ? nullptr : found->plan;
}

/// In the place of what was in memory of it.
void PlanStore::put_first(const std::string& id, OpenedPlanPtr plan) const {
  std::erase_if(opened_, [&](const Opened& one) { return one.id == id; });
  opened_.push_front({id, std::move(plan)});
  if (opened_.size() > kOpenedAtOnce) opened_.pop_back();
}

OpenedPlanPtr PlanStore::open(const std::string& id) const {
  std::uint64_t writes = 0;
  {
    const std::lock_guard lock(mutex_);
    writes = writes_;
    if (OpenedPlanPtr known = plans_.contains(id) ? opened_before(id) : nullptr) return known;
  }
  io::PlanFile file = on_disk(id);
  auto out = std::make_shared<const OpenedPlan>(OpenedPlan{std::move(file.plan), notes_in(file.remarks)});
  const std::lock_guard lock(mutex_);
  // What was written meanwhile may be this plan.
  if (writes == writes_) put_first(id, out);
  return out;
}

KeptPlan PlanStore::rename(const std::string& id, const std::string& name) {
  const std::lock_guard one_at_a_time(changing_);
  const KeptPlan known = get(id);
  OpenedPlan renamed = *open(id);
  renamed.notes.name = name;
  renamed.notes.draft = false;
  return write(id, known.created, std::move(renamed));
}

KeptPlan PlanStore::keep(const std::string& id) {
  const KeptPlan known = get(id);
  return known.draft ? rename(id, known.name) : known;
}

void PlanStore::remove(const std::string& id) {
  const std::lock_guard one_at_a_time(changing_);
  const std::lock_guard lock(mutex_);
  if (plans_.erase(id) == 0) throw not_found("plan", id);
  std::error_code ignored;
  std::filesystem::remove(folder_.file(kPlans, id), ignored);
}

}  // namespace tramline::server
