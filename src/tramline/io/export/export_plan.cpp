#include "tramline/io/export/export_plan.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/coverage/coverage_layers.h"
#include "tramline/io/coverage/read_coverage.h"
#include "tramline/io/export/column_names.h"
#include "tramline/io/export/layer_copy.h"
#include "tramline/io/export/target_crs.h"
#include "tramline/io/export/thinned_line.h"
#include "tramline/io/export/zip_folder.h"
#include "tramline/io/gdal/start_gdal.h"
#include "tramline/io/geopackage/gdal_errors.h"
#include "tramline/io/geopackage/local_crs.h"
#include "tramline/io/geopackage/memory_folder.h"
#include "tramline/io/geopackage/rows.h"
#include "tramline/io/geopackage/time_stamp.h"
#include "tramline/io/geopackage/whole_file.h"
#include "tramline/io/plan/fields_in.h"
#include "tramline/io/plan/plan_layers.h"
#include "tramline/io/plan/read_plan.h"

namespace tramline::io {
namespace {

std::string listed(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

OGRLayer& stored(GDALDataset& plan, const std::string& name) {
  return *plan.GetLayerByName(layer_in_plan_file(name).c_str());
}

/// The layers of the plan file that have shapes, in its order, as they are called in exports.
std::vector<std::string> layers_with_shapes(GDALDataset& plan) {
  std::vector<std::string> out;
  for (OGRLayer* layer : plan.GetLayers())
    if (layer->GetGeomType() != wkbNone) out.push_back(exported_layer(layer->GetName()));
  return out;
}

/// What is driven: the tracks, and headland passes where there are some.
std::vector<std::string> lines_of(GDALDataset& plan) {
  OGRLayer* const passes = plan.GetLayerByName(plan_layers::kHeadlandPasses);
  if (passes == nullptr || passes->GetFeatureCount() == 0) return {plan_layers::kTracks};
  return {plan_layers::kTracks, plan_layers::kHeadlandPasses};
}

/// Tracks and headland passes, in one layer where a file holds no more.
bool are_lines(const std::vector<std::string>& layers) {
  return layers.size() == 2 && std::all_of(layers.begin(), layers.end(), [](const std::string& name) {
           return name == plan_layers::kTracks || name == plan_layers::kHeadlandPasses;
         });
}

/// Where a coverage file holds no tracks, the gaps are what others want to know.
std::vector<std::string> usual_layers(GDALDataset& file) {
  if (file.GetLayerByName(plan_layers::kTracks) == nullptr) return {coverage_layers::kGaps};
  return lines_of(file);
}

std::vector<std::string> chosen_layers(GDALDataset& plan, const ExportRequest& request, ExportFormat format) {
  const std::vector<std::string> all = layers_with_shapes(plan);
  if (request.layers.empty()) {
    if (format == ExportFormat::kShapefiles) return all;
    std::vector<std::string> out = usual_layers(plan);
    if (!single_layer(format) && std::find(all.begin(), all.end(), kRoute) != all.end())
      out.emplace_back(kRoute);
    return out;
  }
  std::vector<std::string> out;
  for (const std::string& name : request.layers) {
    if (std::find(all.begin(), all.end(), name) == all.end())
      throw bad_input(fmt::format("{}: there is no layer '{}' to export; there are {}", request.plan.string(),
                                  name, listed(all)));
    if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
  }
  if (single_layer(format) && out.size() > 1 && !are_lines(out))
    throw bad_input(fmt::format("a {} file holds one layer, not {}; export to .zip or .kml, or one by one",
                                name(format), listed(out)));
  return out;
}

void require_something(GDALDataset& plan, const ExportRequest& request,
                       const std::vector<std::string>& layers) {
  for (const std::string& name : layers)
    if (stored(plan, name).GetFeatureCount() > 0) return;
  throw bad_input(fmt::format("{}: there is nothing in {} {}, so there is nothing to export",
                              request.plan.string(), layers.size() == 1 ? "layer" : "the layers",
                              listed(layers)));
}

void register_drivers() {
  start_gdal();
  RegisterOGRGeoPackage();
  RegisterOGRGeoJSON();
  RegisterOGRFlatGeobuf();
  RegisterOGRKML();
  RegisterOGRShape();
}

GDALDriver& driver_for(ExportFormat format) {
  GDALDriver* found = GetGDALDriverManager()->GetDriverByName(driver_of(format));
  if (found == nullptr) throw failure(fmt::format("this GDAL cannot write {}", name(format)));
  return *found;
}

GDALDatasetUniquePtr opened_plan(const std::filesystem::path& plan) {
  const char* const drivers[] = {"GPKG", nullptr};
  GDALDatasetUniquePtr out(
      GDALDataset::Open(plan.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, nullptr, nullptr));
  if (out == nullptr) throw bad_input(fmt::format("{}: the plan cannot be opened", plan.string()));
  return out;
}

/// What is exported of a plan file: the field, in the frame of its layers, and the rows.
struct Chosen {
  Field field;
  std::size_t fields = 1;
  std::optional<std::string> key;                           ///< only its rows; nullopt: all
  std::map<std::string, LocalFrame, std::less<>> frames{};  ///< see LayerWay
};

/// Of a coverage file. Its coordinate reference system is that of its plane: the source's is not in it.
Chosen chosen_of_coverage(const ExportRequest& request) {
  const Coverage coverage = read_coverage(request.plan);
  if (!request.field.empty() && request.field != coverage.field_id)
    throw bad_input(fmt::format("{}: there is no field '{}' in it; it is of field '{}'",
                                request.plan.string(), request.field, coverage.field_id));
  Chosen out;
  out.field.id = coverage.field_id;
  out.field.frame = coverage.frame;
  out.field.source.input_crs = coverage.frame.geodetic ? "EPSG:4326" : "";
  return out;
}

Chosen chosen_from(const ExportRequest& request) {
  if (is_coverage_file(request.plan)) return chosen_of_coverage(request);
  const std::vector<FieldNames> fields = fields_in(request.plan);
  if (fields.empty())
    return {read_plan(request.plan, request.field).field, 1, std::nullopt, frames_in(request.plan)};
  Chosen out;
  out.frames = frames_in(request.plan);
  out.fields = fields.size();
  if (!request.field.empty() || fields.size() == 1) {
    out.key = chosen_field(fields, request.field, request.plan).key;
    out.fields = 1;
  }
  out.field = read_plan(request.plan, out.key.value_or(fields.front().key)).field;
  out.field.frame = frame_of_layers(request.plan, out.field.frame);
  return out;
}

/// The file, or all that belongs into the zip, in the folder. Its name is always the same: some formats
/// write it down.
void write_layers(GDALDataset& from, const Chosen& plan, const std::vector<std::string>& layers,
                  const TargetCrs& target, double tolerance_m, const std::string& name,
                  ExportReport& report) {
  const GDALDatasetUniquePtr file(
      driver_for(report.format).Create(name.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  if (file == nullptr) return;
  const LayerWay way{report.format,   target,      offset_of(plan.field.frame),
                     time_of_files(), tolerance_m, plan.frames};
  if (single_layer(report.format) && are_lines(layers)) {
    const auto [tracks, passes] =
        copy_lines(*from.GetLayerByName(plan_layers::kTracks),
                   *from.GetLayerByName(plan_layers::kHeadlandPasses), *file, way, report.shortened);
    report.layers = {{plan_layers::kTracks, tracks}, {plan_layers::kHeadlandPasses, passes}};
    return;
  }
  for (const std::string& layer : layers)
    report.layers.push_back({layer, copy_layer(stored(from, layer), *file, way, report.shortened)});
}

/// Layers hand out the rows of that field only, from now on.
void choose_rows(GDALDataset& plan, const std::string& key) {
  for (OGRLayer* layer : plan.GetLayers())
    if (layer->GetLayerDefn()->GetFieldIndex(kFieldKey) >= 0)
      layer->SetAttributeFilter(filter_for(key).c_str());
}

}  // namespace

ExportReport export_plan(const ExportRequest& request) {
  require_tolerance(request.tolerance_m);
  ExportReport report;
  report.format = export_format_of(request.file);
  const Chosen plan = chosen_from(request);
  register_drivers();
  GdalErrors errors;
  const GDALDatasetUniquePtr from = opened_plan(request.plan);
  if (plan.key) choose_rows(*from, *plan.key);
  const std::vector<std::string> layers = chosen_layers(*from, request, report.format);
  require_something(*from, request, layers);
  const TargetCrs target(plan.field, request.crs, report.format);
  report.field_id = plan.field.id;
  report.fields = plan.fields;
  report.crs = target.name();

  const bool zipped = report.format == ExportFormat::kShapefiles;
  const MemoryFolder folder;
  const std::string result = zipped ? "plan.zip" : "plan" + request.file.extension().string();
  write_layers(*from, plan, layers, target, request.tolerance_m, zipped ? folder.path() : folder.file(result),
               report);
  if (zipped) zip_files(folder, folder.files(), result, time_of_files());
  const std::span<const std::byte> bytes = folder.bytes(result);
  if (errors.any() || bytes.empty())
    throw failure(fmt::format("cannot write {}: GDAL reports: {}", request.file.string(), errors.first()));
  write_whole(request.file, bytes);
  return report;
}

}  // namespace tramline::io
