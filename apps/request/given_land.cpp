#include "request/given_land.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "request/evaluate_input.h"
#include "request/field_key.h"
#include "tramline/admission/given/place_subfields.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"
#include "tramline/headland/pass_ground.h"
#include "tramline/io/coverage/read_coverage.h"
#include "tramline/io/plan/fields_in.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/vector/read_vector.h"

namespace tramline::app {
namespace {

RawDataset dataset_of(const std::string& file, std::vector<std::string> columns, LandCrs crs) {
  io::VectorQuery query;
  query.file = file;
  query.all_layers = true;
  query.attributes = std::move(columns);
  RawDataset out = io::read_vector(query);
  if (crs == LandCrs::kPlain)
    for (RawLayer& layer : out.layers) layer.crs.clear();
  return out;
}

/// The polygons of a file, for an option that takes nothing else.
std::vector<LooseObstacle> polygons_of(const std::string& file, const char* option,
                                       const std::string& fields_crs, LandCrs crs) {
  std::vector<LooseObstacle> out =
      read_obstacles(dataset_of(file, {}, crs), ObstacleKind::kObstacle, fields_crs);
  for (const LooseObstacle& feature : out)
    if (feature.polygons.empty())
      throw bad_input(fmt::format("{}: {} takes polygons, and this is none", feature.origin, option));
  return out;
}

/// The land that a plan's tracks and headland passes work.
Region worked_by(const Plan& plan) {
  Region out = swaths(plan);
  for (const HeadlandPass& pass : plan.headland.passes)
    for (Polygon& part : pass_ground_parts(pass.path, plan.machine.width_m, kLayerSagitta))
      out.push_back(std::move(part));
  for (Polygon& polygon : out) polygon = oriented(std::move(polygon));
  return unite(out);
}

std::vector<DoneLand> done_by_plans(const std::string& file) {
  std::vector<DoneLand> out;
  const std::vector<io::FieldNames> fields = io::fields_in(file);
  if (fields.empty()) {
    const Plan plan = io::read_plan(file);
    out.push_back({file, "", plan.field.id, worked_by(plan), plan.field.frame});
  }
  for (const io::FieldNames& field : fields) {
    const Plan plan = io::read_plan(file, field.key);
    out.push_back({file, field.key, field.id, worked_by(plan), plan.field.frame});
  }
  return out;
}

/// Frames farther apart than any field is wide.
bool lie_apart(const LocalFrame& a, const LocalFrame& b) {
  constexpr double kApart_deg = 1;
  return a.geodetic && (std::abs(a.origin_lon_deg - b.origin_lon_deg) > kApart_deg ||
                        std::abs(a.origin_lat_deg - b.origin_lat_deg) > kApart_deg);
}

/// The part of the land within the field's outer ring, in the field's frame.
Region within(const DoneLand& done, const Field& field) {
  if (!done.field.empty() && done.field != field_key(field) && done.field_id != field.id) return {};
  if (done.frame.geodetic != field.frame.geodetic)
    throw bad_input(
        fmt::format("{}: its land and field '{}' are not in the same coordinates, one being in plain "
                    "metres; give --crs",
                    done.file, field.id));
  if (lie_apart(done.frame, field.frame)) return {};
  const Region land = moved(done.land, done.frame, field.frame);
  if (!intersects(bounds(land), bounds(field.outer))) return {};
  return intersection(unite(land), {{field.outer, {}}});
}

/// The land with cracks closed that are narrower than 2 cm: swaths side by side hardly ever meet exactly.
Region without_cracks(const Region& land) {
  constexpr double kHalfCrack_m = 0.01;
  if (land.empty()) return {};
  return buffered(buffered(land, kHalfCrack_m, JoinStyle::kMitre), -kHalfCrack_m, JoinStyle::kMitre);
}

Point middle_of(const LooseObstacle& feature) { return feature.bounds.centre(); }

void append_text(const Region& region, std::string& out) {
  for (const Ring& ring : rings_of(region)) {
    for (const Point p : ring) out += fmt::format("{} {},", p.x, p.y);
    out += ';';
  }
  out += '\n';
}

}  // namespace

LandFiles::LandFiles(const LandOptions& options, const std::string& fields_crs, LandCrs land_crs)
    : options_(options) {
  if (!options.subfields_file.empty())
    subfields_ =
        read_subfields(dataset_of(options.subfields_file,
                                  {kDirectionColumn, kGuideColumn, kSkipColumn, kNameColumn}, land_crs),
                       fields_crs);
  used_.assign(subfields_.size(), 0);
  if (!options.only_file.empty()) {
    only_ = Shapes{
        "--only", options.only_file, polygons_of(options.only_file, "--only", fields_crs, land_crs), {}};
    only_->used.assign(only_->features.size(), 0);
  }
  for (const std::string& file : options.done_files) {
    if (io::is_coverage_file(file)) {
      Coverage coverage = io::read_coverage(file);
      done_lands_.push_back({file, "", coverage.field_id, std::move(coverage.covered), coverage.frame});
    } else if (io::is_plan_file(file)) {
      for (DoneLand& land : done_by_plans(file)) done_lands_.push_back(std::move(land));
    } else {
      done_shapes_.push_back({"--done", file, polygons_of(file, "--done", fields_crs, land_crs), {}});
      done_shapes_.back().used.assign(done_shapes_.back().features.size(), 0);
    }
  }
  done_used_.assign(done_lands_.size(), 0);
}

GivenLand LandFiles::given_for(const Field& field) {
  GivenLand out;
  place_subfields(field, subfields_, used_, out);
  if (only_) {
    const Region whole{{field.outer, {}}};
    const Region only = placed_land(field, only_->features, only_->used);
    out.elsewhere = only.empty() ? whole : difference(whole, only);
  }
  Region done;
  for (Shapes& shapes : done_shapes_)
    for (Polygon& polygon : placed_land(field, shapes.features, shapes.used))
      done.push_back(std::move(polygon));
  for (std::size_t i = 0; i < done_lands_.size(); ++i) {
    for (Polygon& polygon : within(done_lands_[i], field)) {
      done_used_[i] = 1;
      done.push_back(std::move(polygon));
    }
  }
  out.done = without_cracks(unite(done));
  return out;
}

void LandFiles::require_used(const std::string& option, const std::string& file, bool used,
                             const std::string& fields) {
  if (used) return;
  throw bad_input(
      fmt::format("nothing in the file '{}' of {} lies in {}: check its coordinates, and whether it "
                  "was drawn on another field",
                  file, option, fields));
}

std::vector<Skipped> LandFiles::finish(const std::string& fields) const {
  const auto any = [](const std::vector<char>& used) {
    return std::any_of(used.begin(), used.end(), [](char one) { return one != 0; });
  };
  std::vector<Skipped> out;
  const auto add = [&out](const char* what, const LooseObstacle& feature) {
    const Point at = middle_of(feature);
    out.push_back({what, fmt::format("{} at ({:.7g}, {:.7g})", feature.origin, at.x, at.y),
                   "it does not meet any field read"});
  };
  if (!options_.subfields_file.empty())
    require_used("--subfields", options_.subfields_file, any(used_), fields);
  for (std::size_t i = 0; i < subfields_.size(); ++i)
    if (used_[i] == 0) add("subfield", subfields_[i].feature);
  std::vector<const Shapes*> all;
  if (only_) all.push_back(&*only_);
  for (const Shapes& shapes : done_shapes_) all.push_back(&shapes);
  for (const Shapes* shapes : all) {
    require_used(shapes->option, shapes->file, any(shapes->used), fields);
    for (std::size_t i = 0; i < shapes->features.size(); ++i)
      if (shapes->used[i] == 0) add("polygon", shapes->features[i]);
  }
  for (const std::string& file : options_.done_files) {
    bool is_land = false, used = false;
    for (std::size_t i = 0; i < done_lands_.size(); ++i) {
      if (done_lands_[i].file != file) continue;
      is_land = true;
      used = used || done_used_[i] != 0;
    }
    if (is_land) require_used("--done", file, used, fields);
  }
  return out;
}

std::string text_of(const GivenLand& given) {
  std::string out;
  for (const GivenSubfield& subfield : given.subfields) {
    out += fmt::format("{} {}\n", subfield.origin, subfield.direction ? subfield.direction->degrees() : -1);
    append_text(subfield.shape, out);
    append_text({{subfield.guide, {}}}, out);
  }
  for (const GivenCut& cut : given.cuts) append_text({{cut.line, {}}}, out += cut.origin);
  for (const Region* region : {&given.left_out, &given.done, &given.elsewhere}) append_text(*region, out);
  return out;
}

}  // namespace tramline::app
