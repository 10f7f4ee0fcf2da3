#pragma once
// The store of plans, which are ordinary plan files.

#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "server/store/store_folder.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/model/plan.h"

namespace tramline::server {

/// What driving the whole route of a plan takes.
struct RouteFigures {
  double hours = 0;
  double litres = 0;
  double euros = 0;
};

/// An entry of the list of plans, with the data needed to show the plan.
struct KeptPlan {
  std::string id;
  std::string name;
  std::string field;  ///< id of the field it was made for; that may be gone
  std::string created;
  std::string kind;  ///< "plan" or "repair"
  double cost = 0;
  Tally tally;
  double width_m = 0;
  LocalFrame frame;
  bool draft = false;                   ///< see PlanNotes
  std::optional<RouteFigures> route{};  ///< where it has a route
  std::string shape{};                  ///< of the field, as shape_key(); empty: not known
};

/// Data on a plan in addition to those of its file.
struct PlanNotes {
  std::string name;
  std::string field;
  std::vector<Skipped> skipped;
  double seconds = 0;
  nlohmann::ordered_json explain;  ///< null: it was not asked for
  bool draft = false;  ///< made on the way to another one: the next draft of its field replaces it
  nlohmann::ordered_json asked{};  ///< machine, objective and settings of the request; null: it is not known
  std::string shape{};             ///< of the field that was planned, as shape_key()
};

/// A plan with its notes.
struct OpenedPlan {
  Plan plan;
  PlanNotes notes;
};

using OpenedPlanPtr = std::shared_ptr<const OpenedPlan>;

/// plans/ID.gpkg. Safe for several threads.
class PlanStore {
 public:
  PlanStore(const StoreFolder& folder, std::vector<std::string>& warnings);

  /// The latest first; of one field where `field` is not empty.
  std::vector<KeptPlan> list(const std::string& field) const;
  /// These throw HttpError(kNotFound).
  KeptPlan get(const std::string& id) const;
  std::filesystem::path file(const std::string& id) const;
  /// What its file says, whatever is in memory of it.
  io::PlanFile on_disk(const std::string& id) const;
  /// The last few stay in memory: whoever looks at a plan, or edits it, asks for it several times.
  OpenedPlanPtr open(const std::string& id) const;
  /// A plan with a name of its own is no draft. One at a time, and none brings back what is deleted.
  KeptPlan rename(const std::string& id, const std::string& name);
  /// From now on it is no draft: only remove() drops it.
  KeptPlan keep(const std::string& id);
  void remove(const std::string& id);

  /// A draft drops the drafts that were there of its field, once it is stored itself; but for the one that it
  /// is an edit of, which its user may go back to.
  KeptPlan add(Plan plan, PlanNotes notes);

 private:
  KeptPlan read(const std::string& id) const;
  void drop_other_drafts(const KeptPlan& newest, const std::string& edited);
  KeptPlan write(const std::string& id, const std::string& created, OpenedPlan opened);
  OpenedPlanPtr opened_before(const std::string& id) const;
  void put_first(const std::string& id, OpenedPlanPtr plan) const;

  const StoreFolder& folder_;
  std::mutex changing_;  ///< taken before mutex_
  mutable std::mutex mutex_;
  std::map<std::string, KeptPlan> plans_;
  struct Opened {
    std::string id;
    OpenedPlanPtr plan;
  };
  mutable std::deque<Opened> opened_;  ///< the latest first
  std::uint64_t writes_ = 0;           ///< how often a file was written; guarded by mutex_
};

}  // namespace tramline::server
