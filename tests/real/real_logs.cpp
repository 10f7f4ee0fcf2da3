#include "real/real_logs.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "tramline/coverage/drive/log_sanity.h"
#include "tramline/coverage/drive/time_order.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/geodesy/placed_log.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/body.h"
#include "tramline/io/log/read_log.h"

namespace tramline::testing {
namespace {

std::filesystem::path folder() { return std::filesystem::path(real_data_folder()) / "logs"; }

/// Valid polygons: a bow-tie becomes its two triangles.
Region shapes_of(const coverage::WorkedStep& step) {
  Region out;
  for (const coverage::Quad& quad : step.quads)
    for (Polygon& polygon : made_valid({Ring(quad.begin(), quad.end()), {}}))
      out.push_back(std::move(polygon));
  return out;
}

/// Ground inside at least two of the shapes: halves first, so that each overlay has few parts. What is inside
/// both halves is inside two; the rest is within one of them.
struct Layers {
  Region once;
  Region twice;
};
Layers layers_of(const Region& shapes, std::size_t first, std::size_t last) {
  if (last - first == 1) return {{shapes[first]}, {}};
  const std::size_t middle = (first + last) / 2;
  const Layers a = layers_of(shapes, first, middle);
  const Layers b = layers_of(shapes, middle, last);
  Region twice = intersection(a.once, b.once);
  twice.insert(twice.end(), a.twice.begin(), a.twice.end());
  twice.insert(twice.end(), b.twice.begin(), b.twice.end());
  return {unite(a.once, b.once), twice.empty() ? Region{} : unite(twice)};
}

}  // namespace

std::vector<std::string> real_logs() {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(folder()))
    if (entry.path().extension() != ".json") out.push_back(entry.path().filename().string());
  std::sort(out.begin(), out.end());
  return out;
}

WorkLog real_log_as_read(const std::string& name) { return io::read_log((folder() / name).string()); }

WorkLog real_log(const std::string& name, const LocalFrame& frame) {
  return placed(real_log_as_read(name), frame);
}

WorkLog real_log(const std::string& name) {
  const WorkLog log = real_log_as_read(name);
  return placed(log, frame_centred_on(log));
}

Field field_named(const RealFields& fields, const std::string& id) {
  const Crs crs(fields.dataset.layers.front().crs);
  for (const RawFeature& feature : fields.features())
    for (const Field& field : admitted(fields, crs, feature))
      if (field.id == id) return field;
  throw std::runtime_error("no field " + id);
}

Region ground_of(const Field& field) {
  Region out;
  for (const Polygon& polygon : body_of(field)) out.push_back(oriented(polygon));
  return out;
}

BatchDifference stream_against_batch(const WorkLog& given, const Region& field,
                                     const coverage::DriveSettings& drive) {
  coverage::EvaluateSettings settings;
  settings.drive = drive;
  const Coverage stream = coverage::evaluate(given, field, settings, {});

  const WorkLog log = coverage::in_time_order(coverage::log_without_faults(given));
  settings.drive.unknown_work = coverage::says_work(log) ? WorkState::kOff : WorkState::kOn;
  coverage::StepMaker steps(settings.drive);
  Region shapes;
  for (const Fix& fix : log.fixes)
    if (const auto step = steps.add(fix, log.booms))
      for (Polygon& shape : shapes_of(*step)) shapes.push_back(std::move(shape));
  const Layers batch = layers_of(shapes, 0, shapes.size());
  const double inside_m2 = field.empty() ? 0 : area(intersection(batch.once, field));

  const CoverageAreas& areas = stream.areas;
  const double worked_m2 = area(batch.once);
  const auto share = [&](double found, double wanted) { return std::abs(found - wanted) / worked_m2; };
  return {
      std::max({share(areas.covered_m2, worked_m2), share(areas.covered_inside_m2, inside_m2),
                share(areas.missed_m2, area(field) - inside_m2),
                share(areas.worked_twice_m2(), area(batch.twice))}),
      std::max({share(area(stream.covered), worked_m2), share(area(stream.missed), area(field) - inside_m2),
                share(area(stream.worked_times[2]) + area(stream.worked_times[3]), area(batch.twice))})};
}

}  // namespace tramline::testing
