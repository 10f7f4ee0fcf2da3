#include "request/price_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "tramline/admission/lines/path_along.h"
#include "tramline/admission/lines/read_lines.h"
#include "tramline/geodesy/field_projection.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/exact_path.h"
#include "tramline/io/plan/fields_in.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/vector/read_vector.h"

namespace tramline::app {
namespace {

Field field_typed(const FieldOptions& options, std::vector<Skipped>& skipped) {
  FieldInput input = load_fields(options);
  if (input.fields.size() > 1)
    throw bad_input(
        fmt::format("'{}' holds a field of {} parts; lines are priced on one: choose it with --id {}",
                    options.file, input.fields.size(), input.fields.front().id));
  for (Skipped& left_aside : input.skipped) skipped.push_back(std::move(left_aside));
  return std::move(input.fields.front());
}

/// From the plane of a plan's own field to that of another.
class ToField {
 public:
  ToField(const LocalFrame& from, const Field& field) : from_frame_(from), field_(field) {
    if (from.geodetic != field.frame.geodetic)
      throw bad_input(
          fmt::format("the plan and field '{}' are not in the same coordinates; give --crs", field.id));
    if (from == field.frame || !from.geodetic) return;
    from_.emplace(from);
    to_.emplace(field.frame);
  }

  /// Throws kBadInput where the path has no place in the field's plane.
  Path operator()(const Path& path) const {
    if (from_frame_ == field_.frame) return path;
    Path out = moved(path, [this](Point p) { return placed(p); });
    // An arc of half a circle would have become longer than that by rounding.
    for (PathSegment& segment : out) {
      const double most = 2 / std::max(distance(segment.from, segment.to), 1e-9);
      segment.curvature = std::clamp(segment.curvature, -most, most);
    }
    return out;
  }

 private:
  Point placed(Point p) const {
    if (!from_)
      return p + Point{from_frame_.origin_x_m - field_.frame.origin_x_m,
                       from_frame_.origin_y_m - field_.frame.origin_y_m};
    const std::optional<Point> local = to_->from_lonlat(from_->to_lonlat(p));
    if (!local) throw bad_input(fmt::format("the plan lies too far from field '{}'", field_.id));
    return *local;
  }

  const LocalFrame& from_frame_;
  const Field& field_;
  std::optional<FrameProjection> from_, to_;
};

/// What a plan calls a crossing may no longer be one in another field.
WayHere way_here(const TrackPiece& piece) {
  return piece.after_crossing ? WayHere::kUnknown : WayHere::kTurn;
}

void append_lines_of(const Plan& plan, const Field& field, GivenLines& out) {
  const ToField to_field(plan.field.frame, field);
  for (std::size_t i = 0; i < plan.pieces.size(); ++i)
    out.tracks.push_back({to_field(centre_line(plan.pieces[i])), static_cast<int>(plan.pieces[i].subfield),
                          fmt::format("track {}", i + 1), way_here(plan.pieces[i])});
  for (std::size_t i = 0; i < plan.headland.passes.size(); ++i)
    out.passes.push_back({to_field(plan.headland.passes[i].path), 0, fmt::format("headland pass {}", i + 1),
                          WayHere::kUnknown});
}

bool is_machine_typed(const PlanOptions& options) {
  return options.width_m.has_value() || !options.machine_file.empty();
}

bool are_prices_typed(const PlanOptions& options) {
  return !options.like.empty() || !options.weights.empty() || !options.prices.empty() ||
         !options.minimise.empty();
}

PriceInput input_of_plan(const std::string& file, const FieldOptions& field, const PlanOptions& options) {
  PriceInput out;
  if (!field.file.empty()) out.field = field_typed(field, out.skipped);
  const bool many = !io::fields_in(file).empty();
  if (many && field.file.empty())
    throw bad_input(fmt::format(
        "'{}' holds the plans of several fields: give the file of the fields with --field, and one with --id",
        file));
  Plan plan = io::read_plan(file, many ? out.field.id : "");
  if (is_repair(plan))
    throw bad_input(fmt::format(
        "'{}' is a repair: it works the gaps of a drive, and there is no price for them on the whole field",
        file));
  if (field.file.empty()) out.field = plan.field;
  append_lines_of(plan, out.field, out.lines);
  out.machine = is_machine_typed(options) ? machine_of(options) : plan.machine;
  if (!is_machine_typed(options) && options.radius_m) out.machine.radius_m = *options.radius_m;
  if (!is_machine_typed(options) && options.min_length_m) out.machine.min_length_m = *options.min_length_m;
  out.objective = are_prices_typed(options) ? objective_of(options) : plan.objective;
  out.settings = settings_of(options);
  if (options.clearance_m == 0) out.settings.clearance_m = plan.settings.clearance_m;
  return out;
}

/// Why lines are priced along the chords that are drawn, though an export knew their exact path.
struct DrawnOnly {
  int elsewhere = 0;   ///< they do not run along it any more
  int unreadable = 0;  ///< the text is cut, or changed
};

/// The exact path of a line of our own export, as long as the line runs along it.
std::optional<Path> exact_path_of(const DrawnLine& line, const std::vector<Point>& points, const Field& field,
                                  DrawnOnly& reasons) {
  if (line.exact_path.empty() || points.empty()) return std::nullopt;
  const std::optional<io::ExactPath> exact = io::exact_path_from_text(line.exact_path);
  if (!exact) {
    ++reasons.unreadable;
    return std::nullopt;
  }
  // Digits of coordinates in degrees, and of other programs.
  constexpr double kDigits_m = 1e-3;
  try {
    const Path path = ToField(exact->frame, field)(exact->path);
    if (std::optional<Path> out = path_along(path, points, exact->within_m + kDigits_m)) return out;
  } catch (const Error&) {  // a path of another kind of coordinates, or of another part of the world
  }
  ++reasons.elsewhere;
  return std::nullopt;
}

void append_notes(const DrawnOnly& reasons, std::size_t lines, std::vector<std::string>& notes) {
  const auto add = [&](int count, const char* why) {
    if (count > 0)
      notes.push_back(
          fmt::format("{} of {} lines {} priced as drawn: {}", count, lines, count == 1 ? "is" : "are", why));
  };
  add(reasons.elsewhere, "moved or cut since the export, off the path in the column exact_path");
  add(reasons.unreadable, "the column exact_path is not as exported");
}

PriceInput input_of_lines(const LinesOptions& lines, const FieldOptions& field, const PlanOptions& options) {
  if (field.file.empty())
    throw bad_input("--field is needed: the lines of a file do not say which field is theirs");
  if (!is_machine_typed(options))
    throw bad_input(
        "--width is needed: lines do not say how wide the machine is (or --machine, with its width)");
  PriceInput out;
  out.machine = machine_of(options);
  out.objective = objective_of(options);
  out.settings = settings_of(options);
  out.field = field_typed(field, out.skipped);
  io::VectorQuery query;
  query.file = lines.file;
  query.layer = lines.layer;
  query.where = lines.where;
  query.shapes = io::WantedShapes::kLines;
  query.attributes = columns_of_lines();
  const std::string& crs = out.field.source.input_crs;
  DrawnLines drawn = read_lines(lines.in_memory ? *lines.in_memory : io::read_vector(query), crs);
  for (Skipped& left_aside : drawn.skipped) out.skipped.push_back(std::move(left_aside));
  DrawnOnly as_drawn;
  for (const DrawnLine& line : drawn.lines) {
    const std::vector<Point> points = placed_line(line, out.field);
    Path path;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) path.push_back({points[i], points[i + 1], 0});
    if (std::optional<Path> exact = exact_path_of(line, points, out.field, as_drawn))
      path = *std::move(exact);
    (line.is_pass ? out.lines.passes : out.lines.tracks)
        .push_back({std::move(path), line.subfield, line.origin,
                    line.after_turn ? WayHere::kTurn : WayHere::kUnknown});
  }
  append_notes(as_drawn, drawn.lines.size(), out.lines.notes);
  return out;
}

}  // namespace

PriceInput price_input(const LinesOptions& lines, const FieldOptions& field, const PlanOptions& plan) {
  const bool whole_file = lines.in_memory == nullptr && lines.layer.empty() && lines.where.empty();
  if (whole_file && io::is_plan_file(lines.file)) return input_of_plan(lines.file, field, plan);
  return input_of_lines(lines, field, plan);
}

}  // namespace tramline::app
