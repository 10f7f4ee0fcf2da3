#include "request/field_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "request/field_key.h"
#include "tramline/admission/admit.h"
#include "tramline/admission/read_obstacles.h"
#include "tramline/geometry/error.h"
#include "tramline/io/land/read_fields.h"

namespace tramline::app {
namespace {

constexpr long long kListed = 20;

/// The obstacles of --obstacles and --passable, and which of them lie in a field read so far.
struct Loose {
  std::vector<LooseObstacle> obstacles;
  std::vector<char> used;
};

/// `plain_given`: the user said that coordinates are plain metres, whatever the file says.
void append_obstacles(const std::string& file, ObstacleKind kind, bool plain_given,
                      const std::string& fields_crs, std::vector<LooseObstacle>& out) {
  if (file.empty()) return;
  io::VectorQuery query;
  query.file = file;
  query.all_layers = true;
  RawDataset dataset = io::read_fields(query);
  if (plain_given)
    for (RawLayer& layer : dataset.layers) layer.crs.clear();
  for (LooseObstacle& obstacle : read_obstacles(dataset, kind, fields_crs))
    out.push_back(std::move(obstacle));
}

Loose loose_obstacles(const FieldOptions& options, const Crs& crs, const std::string& definition) {
  Loose out;
  const bool plain_given = crs.plain() && !options.crs.empty();
  append_obstacles(options.obstacles_file, ObstacleKind::kObstacle, plain_given, definition, out.obstacles);
  append_obstacles(options.passable_file, ObstacleKind::kPassable, plain_given, definition, out.obstacles);
  out.used.assign(out.obstacles.size(), 0);
  return out;
}

std::vector<Skipped> unused_obstacles(const Loose& loose) {
  std::vector<Skipped> out;
  for (std::size_t i = 0; i < loose.obstacles.size(); ++i)
    if (!loose.used[i]) {
      const Point at = loose.obstacles[i].bounds.centre();
      out.push_back({loose.obstacles[i].kind == ObstacleKind::kPassable ? "passable strip" : "obstacle",
                     fmt::format("{} at ({:.7g}, {:.7g})", loose.obstacles[i].origin, at.x, at.y),
                     "it does not meet any field read"});
    }
  return out;
}

/// Everything between the raw features and the fields: the CRS, the obstacles, the admission.
class Admitter {
 public:
  Admitter(const FieldOptions& options, const RawDataset& dataset)
      : options_(options),
        layer_(dataset.layers.front()),
        definition_(options.crs.empty() ? layer_.crs : options.crs),
        crs_(definition_),
        loose_(loose_obstacles(options, crs_, definition_)),
        context_{dataset.file, layer_.name, &crs_, dataset.winding} {
    input_.file = dataset.file;
    input_.driver = dataset.driver;
    input_.layer = layer_.name;
    input_.layer_geometry = layer_.geometry_type;
    input_.crs = crs_.name();
    input_.crs_given = !options.crs.empty();
    input_.features = layer_.matching;
    input_.skipped = dataset.skipped;
  }

  /// Throws the refusal.
  void admit(const RawFeature& feature) {
    Admission admission = tramline::admit(feature, context_);
    if (!loose_.obstacles.empty())
      for (Field& field : admission.fields)
        place_obstacles(field, loose_.obstacles, options_.obstacle_size_m, loose_.used);
    for (Field& field : admission.fields) {
      field.source.crs = options_.crs;
      field.source.input_crs = crs_.definition();
      field.source.obstacles_file = options_.obstacles_file;
      field.source.obstacle_size_m = options_.obstacle_size_m;
      field.source.passable_file = options_.passable_file;
      input_.fields.push_back(std::move(field));
    }
    for (Skipped& skipped : admission.skipped) input_.skipped.push_back(std::move(skipped));
  }

  void admit_all() {
    for (const RawFeature& feature : layer_.features) {
      if (!options_.id.empty() &&
          !may_be_named(field_id(feature, layer_.name), layer_.name, feature.fid, options_.id))
        continue;
      try {
        admit(feature);
      } catch (const Error& error) {
        if (error.kind() != ErrorKind::kBadInput) throw;
        input_.refusals.push_back({field_id(feature, layer_.name), error.what(), feature.fid});
      }
    }
  }

  /// Those that the user means. `features` counts what is listed to choose from.
  void keep_named() {
    std::erase_if(input_.fields, [&](const Field& field) { return !is_named(field, options_.id); });
    input_.features =
        static_cast<long long>(input_.fields.size()) + static_cast<long long>(input_.refusals.size());
  }

  FieldInput finish() {
    for (Skipped& skipped : unused_obstacles(loose_)) input_.skipped.push_back(std::move(skipped));
    return std::move(input_);
  }

 private:
  const FieldOptions& options_;
  const RawLayer& layer_;
  std::string definition_;
  Crs crs_;
  Loose loose_;
  AdmissionContext context_;
  FieldInput input_;
};

io::VectorQuery query_of(const FieldOptions& options) {
  io::VectorQuery query;
  query.file = options.file;
  query.layer = options.layer;
  query.where = options.where;
  query.fid = options.fid;
  return query;
}

/// The features that are there already, or those of the file.
RawDataset features_of(const FieldOptions& options, const io::VectorQuery& query) {
  return options.in_memory ? *options.in_memory : io::read_fields(query);
}

[[noreturn]] void refuse_several(const FieldOptions& options, const RawDataset& dataset) {
  FieldOptions bare = options;
  bare.obstacles_file.clear();
  bare.passable_file.clear();
  Admitter admitter(bare, dataset);
  admitter.admit_all();
  const FieldInput input = admitter.finish();
  std::string list;
  const auto add = [&](const std::string& entry) { list += (list.empty() ? "" : ", ") + entry; };
  for (const Field& field : input.fields) {
    const bool unique = std::count_if(input.fields.begin(), input.fields.end(),
                                      [&](const Field& other) { return other.id == field.id; }) == 1;
    add(fmt::format("{} ({:.1f} m²)", unique ? field.id : field_key(field), area_m2(field)));
  }
  for (const Refusal& refusal : input.refusals) add(fmt::format("{} (refused)", refusal.field_id));
  const long long more = input.features - kListed;
  if (more > 0) list += fmt::format(" and {} more", more);
  throw bad_input(fmt::format("'{}' has {} features; take all with --all or choose one with --id: {}",
                              dataset.file, input.features, list));
}

[[noreturn]] void refuse_alike(const FieldOptions& options, const FieldInput& input) {
  std::string list;
  const auto add = [&](const std::string& key, const std::string& what) {
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", key, what);
  };
  for (const Field& field : input.fields) add(field_key(field), fmt::format("{:.1f} m²", area_m2(field)));
  for (const Refusal& refusal : input.refusals) add(field_key(input.layer, refusal.fid), "refused");
  throw bad_input(fmt::format("'{}' has {} fields that are called '{}'; choose one by its key, --id {}",
                              options.file, input.fields.size() + input.refusals.size(), options.id, list));
}

/// The field of --id, or with --all all that are called so.
FieldInput load_named(const FieldOptions& options) {
  const RawDataset dataset = features_of(options, query_of(options));
  Admitter admitter(options, dataset);
  admitter.admit_all();
  admitter.keep_named();
  FieldInput input = admitter.finish();
  if (input.fields.empty() && input.refusals.empty())
    throw bad_input(fmt::format(
        "'{}', layer '{}' has no field that is called '{}'{}: 'tramline info' lists them", dataset.file,
        input.layer, options.id, options.where.empty() ? "" : ", of those that --where leaves"));
  if (options.all) return input;
  if (input.fields.empty()) throw bad_input(input.refusals.front().sentence);
  if (input.fields.size() + input.refusals.size() > 1) refuse_alike(options, input);
  return input;
}

}  // namespace

FieldInput load_fields(const FieldOptions& options) {
  if (!options.id.empty()) return load_named(options);
  io::VectorQuery query = query_of(options);
  if (!options.all) query.limit = kListed;
  const RawDataset dataset = features_of(options, query);
  const RawLayer& layer = dataset.layers.front();
  if (!options.all && layer.features.size() > 1) refuse_several(options, dataset);
  Admitter admitter(options, dataset);
  if (options.all)
    admitter.admit_all();
  else
    admitter.admit(layer.features.front());
  return admitter.finish();
}

FieldInput survey_fields(const FieldOptions& options, long long limit) {
  if (!options.id.empty()) return load_named(options);
  io::VectorQuery query = query_of(options);
  query.limit = limit;
  const RawDataset dataset = features_of(options, query);
  Admitter admitter(options, dataset);
  admitter.admit_all();
  return admitter.finish();
}

Field load_field(const FieldOptions& options, const FieldSource& source) {
  io::VectorQuery query;
  query.file = options.file;
  query.layer = options.layer.empty() ? source.layer : options.layer;
  // GeoJSON and Shapefile layers are called like their file, which may have been renamed.
  query.layer_is_hint = options.layer.empty();
  query.fid = source.fid;
  const RawDataset dataset = features_of(options, query);
  Admitter admitter(options, dataset);
  admitter.admit(dataset.layers.front().features.front());
  FieldInput input = admitter.finish();
  for (Field& field : input.fields)
    if (field.source.part == source.part) return std::move(field);
  throw bad_input(fmt::format("'{}', layer '{}', feature {} has {} part(s), so there is no part {}",
                              dataset.file, source.layer, source.fid, input.fields.size(), source.part + 1));
}

}  // namespace tramline::app
