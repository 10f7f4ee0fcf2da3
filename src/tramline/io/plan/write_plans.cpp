#include "tramline/io/plan/write_plans.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "tramline/geometry/error.h"
#include "tramline/io/geopackage/gdal_errors.h"
#include "tramline/io/geopackage/layer_styles.h"
#include "tramline/io/geopackage/local_crs.h"
#include "tramline/io/geopackage/remarks.h"
#include "tramline/io/geopackage/write_geopackage.h"
#include "tramline/io/plan/common_frame.h"
#include "tramline/io/plan/plan_collection.h"
#include "tramline/io/plan/plan_layers.h"
#include "tramline/io/plan/plan_metadata.h"
#include "tramline/io/plan/plan_rows.h"
#include "tramline/io/plan/plan_styles.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/route_rows.h"

namespace tramline::io {
namespace {

namespace fs = std::filesystem;

LocalFrame frame_of(const fs::path& file) {
  Plan plan;
  apply_metadata(read_metadata(file, kPlanFile), file, plan);
  return plan.field.frame;
}

LocalFrame frame_for(const std::vector<KeptPlan>& plans) {
  std::vector<LocalFrame> frames;
  for (const KeptPlan& plan : plans) frames.push_back(frame_of(plan.file));
  return common_frame(frames);
}

/// A reader that asks for one field of many need not look at the rows of all.
void make_indexes(GDALDataset& file) {
  std::vector<std::string> tables;
  for (OGRLayer* layer : file.GetLayers())
    if (layer->GetLayerDefn()->GetFieldIndex(kFieldKey) >= 0) tables.emplace_back(layer->GetName());
  for (const std::string& table : tables)
    file.ReleaseResultSet(file.ExecuteSQL(
        fmt::format("CREATE INDEX \"{0}_{1}\" ON \"{0}\" (\"{1}\")", table, kFieldKey).c_str(), nullptr, ""));
}

/// The rows of many plans, one after the other, and then what there is once.
class Collection {
 public:
  Collection(const LocalFrame& common, const Target& file) : common_(common), file_(file) {}

  void add(const std::string& key, const Plan& plan, const Metadata& remarks) {
    const LocalFrame& frame = plan.field.frame;
    const FieldNames names{key, plan.field.id};
    write_plan_rows({file_.file, file_.crs, offset_of(frame), Shapes(way_between(frame, common_)), &names},
                    plan, remarks);
    most_subfields_ = std::max(most_subfields_, plan.subfields.size());
    if (has_route(plan)) routes_ = Routes::kSome;
  }

  void finish() {
    const FieldNames nobody;
    Table metadata({file_.file, file_.crs, {}, Shapes(Point{}), &nobody}, kMetadataTable, wkbNone,
                   {text("key"), text("value")});
    metadata.add(nullptr, {std::string(kCollectionKey), collection_text(common_)});
    write_styles(file_.file, styles_of_many(most_subfields_, routes_));
    make_indexes(file_.file);
  }

 private:
  const LocalFrame& common_;
  const Target& file_;
  std::size_t most_subfields_ = 0;
  Routes routes_ = Routes::kNone;
};

void write_all(const std::vector<KeptPlan>& plans, const LocalFrame& common, const Target& file) {
  Collection collection(common, file);
  for (const KeptPlan& kept : plans) {
    const PlanFile part = read_plan_file(kept.file);
    collection.add(kept.key, part.plan, part.remarks);
  }
  collection.finish();
}

/// A file under way, gone unless it gets its name. What a killed run has left of one is written over.
class HalfWritten {
 public:
  explicit HalfWritten(const fs::path& target)
      : target_(target), name_(target.parent_path() / fmt::format(".{}.part.gpkg", target.stem().string())) {
    remove();
  }
  HalfWritten(const HalfWritten&) = delete;
  HalfWritten& operator=(const HalfWritten&) = delete;
  ~HalfWritten() { remove(); }
  std::string name() const { return name_.string(); }
  void keep() {
    if (std::rename(name_.c_str(), target_.c_str()) != 0)
      throw failure(
          fmt::format("cannot write {}: {}", target_.string(), std::generic_category().message(errno)));
  }

 private:
  void remove() const {
    std::error_code ignored;
    fs::remove(name_, ignored);
    fs::remove(name_.string() + "-journal", ignored);
  }

  fs::path target_, name_;
};

}  // namespace

void write_plans(const std::vector<KeptPlan>& plans, const fs::path& path) {
  assert(!plans.empty());
  const LocalFrame common = frame_for(plans);
  HalfWritten file(path);
  GdalErrors errors;
  fill_geopackage(file.name(), common, [&](const Target& target) { write_all(plans, common, target); });
  if (errors.any() || !fs::exists(file.name()))
    throw failure(fmt::format("cannot write {}: GDAL reports: {}", path.string(), errors.first()));
  file.keep();
}

void write_plans(const std::vector<KeyedPlan>& plans, const fs::path& path) {
  assert(!plans.empty());
  std::vector<LocalFrame> frames;
  for (const KeyedPlan& plan : plans) frames.push_back(plan.plan->field.frame);
  const LocalFrame common = common_frame(frames);
  write_geopackage(path, kPlanFile, common, [&](const Target& file) {
    Collection collection(common, file);
    for (const KeyedPlan& plan : plans) collection.add(plan.key, *plan.plan, {});
    collection.finish();
  });
}

}  // namespace tramline::io
