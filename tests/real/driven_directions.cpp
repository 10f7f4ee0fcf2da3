// How fields were driven against how they are planned: for each real log on a curated field, and for the line
// of the AgOpenGPS folder, the direction that most of the work was driven in, the plan of least whole cost,
// and the cheapest plan in the direction driven, both priced by the same code.
//
//   driven_directions [RADIUS]
//
// The machine is as wide as the log says, 6 m where it says nothing or more than 60 m, and has this radius,
// by default 6 m. Prints a row for every log; exit code 1 where a plan is more than 10° off the direction
// driven and costs more than a plan in that direction.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "real/plans_along.h"
#include "real/real_fields.h"
#include "real/real_logs.h"
#include "tramline/geodesy/field_projection.h"
#include "tramline/geodesy/placed_log.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/io/land/read_fields.h"
#include "tramline/planner/plan_field.h"

namespace tramline::testing {
namespace {

constexpr double kNear_deg = 10;
constexpr double kUsualWidth_m = 6, kUsualRadius_m = 6;
/// What is said to be wider is no machine.
constexpr double kMostWidth_m = 60;
/// Chords of a drive at least so long have a direction; longer ones than the second number are gaps.
constexpr double kLeastChord_m = 5, kMostChord_m = 30;
constexpr int kAxes = 180;

struct Driven {
  std::string log;
  double width_m = kUsualWidth_m;
  Direction along;
  double share = 0;     ///< of the length of work that is within kNear_deg of it
  double worked_m = 0;  ///< all work on the field
};

/// The length of work by direction, one class a degree.
class ByDirection {
 public:
  void add(Point from, Point to) {
    const double length_m = distance(from, to);
    const auto at = static_cast<std::size_t>(Direction::along(from, to).degrees());
    lengths_m_[std::min<std::size_t>(at, kAxes - 1)] += length_m;
    total_m_ += length_m;
  }
  double total_m() const { return total_m_; }

  /// The middle of the kNear_deg to both sides of which most length lies: the mean of it there.
  Direction main() const {
    int best = 0;
    for (int i = 1; i < kAxes; ++i)
      if (near_m(i) > near_m(best)) best = i;
    double sum_deg = 0;
    for (int off = -kReach; off <= kReach; ++off) sum_deg += off * lengths_m_[index(best + off)];
    return Direction::clockwise_from_north(Angle::degrees(best + 0.5 + sum_deg / near_m(best)));
  }
  double share_near(Direction along) const { return near_m(static_cast<int>(along.degrees())) / total_m_; }

 private:
  static constexpr int kReach = static_cast<int>(kNear_deg);
  static std::size_t index(int i) { return static_cast<std::size_t>((i + kAxes) % kAxes); }
  double near_m(int middle) const {
    double out = 0;
    for (int off = -kReach; off <= kReach; ++off) out += lengths_m_[index(middle + off)];
    return out;
  }
  std::array<double, kAxes> lengths_m_{};
  double total_m_ = 0;
};

double widest_m(const WorkLog& log) {
  double out = 0;
  for (const Boom& boom : log.booms)
    if (!boom.empty()) out = std::max(out, boom.front().left_m - boom.back().right_m);
  return out > 0 && out <= kMostWidth_m ? out : kUsualWidth_m;
}

/// What was driven on the field with the work on, or not known to be off.
ByDirection work_on(const Field& field, const WorkLog& log) {
  ByDirection out;
  const Polygon land{field.outer, {}};
  std::map<int, Point> chord_begins;
  for (const Fix& fix : log.fixes) {
    const auto begun = chord_begins.find(fix.unit);
    if (fix.work == WorkState::kOff || !contains(land, fix.position)) {
      if (begun != chord_begins.end()) chord_begins.erase(begun);
      continue;
    }
    if (begun == chord_begins.end()) {
      chord_begins[fix.unit] = fix.position;
      continue;
    }
    const double chord_m = distance(begun->second, fix.position);
    if (chord_m < kLeastChord_m) continue;
    if (chord_m <= kMostChord_m) out.add(begun->second, fix.position);
    begun->second = fix.position;
  }
  return out;
}

std::optional<Driven> driven_on(const Field& field, const std::string& name, const WorkLog& log) {
  const ByDirection work = work_on(field, placed(log, field.frame));
  if (!(work.total_m() > 0)) return std::nullopt;
  Driven out{name, widest_m(log), work.main(), 0, work.total_m()};
  out.share = work.share_near(out.along);
  return out;
}

Box raw_box(const RawFeature& feature) {
  Box out;
  for (const RawPolygon& polygon : feature.polygons)
    for (const RawRing& ring : polygon.rings)
      for (const Point p : ring.points) out.extend(p);
  return out;
}

/// The curated field that most of the log was driven on, if it was on any.
std::optional<std::pair<Field, Driven>> field_of(const RealFields& fields, const std::string& name) {
  const WorkLog log = real_log_as_read(name);
  const Crs crs(fields.dataset.layers.front().crs);
  std::optional<std::pair<Field, Driven>> out;
  for (const RawFeature& feature : fields.features()) {
    if (!intersects(raw_box(feature), bounds(log))) continue;
    for (const Field& field : admitted(fields, crs, feature)) {
      const auto driven = driven_on(field, name, log);
      if (driven && (!out || driven->worked_m > out->second.worked_m)) out = {field, *driven};
    }
  }
  return out;
}

/// The field of the AgOpenGPS folder and its first line.
std::optional<std::pair<Field, Driven>> field_of_folder() {
  const std::string folder = real_data_folder() + "/agopengps/UserField";
  if (!std::filesystem::exists(folder)) return std::nullopt;
  io::VectorQuery query;
  query.file = folder;
  const RealFields fields{folder, io::read_fields(query)};
  const RawDataset guides = io::read_guides(query);
  const Crs crs(fields.dataset.layers.front().crs);
  std::vector<Field> parts = admitted(fields, crs, fields.features().front());
  const FieldProjection projection(crs, parts.front().frame);
  const std::vector<Point>& line = guides.layers.front().features.front().lines.front();
  const auto from = projection.to_local(line.front()), to = projection.to_local(line.back());
  if (!from || !to) return std::nullopt;
  const Driven driven{"AgOpenGPS line", kUsualWidth_m, Direction::along(*from, *to), 1, 0};
  return std::pair{std::move(parts.front()), driven};
}

/// Whether the plan is near the direction driven or costs no more.
bool print_compared(const Field& field, const Driven& driven, double radius_m) {
  const Machine machine{"", driven.width_m, radius_m, -1};
  const double hectares = area(Polygon{field.outer, {}}) / 1e4;
  fmt::print("{:42} {:36} {:6.2f} {:5.2f} {:5.2f} {:4.0f} % {:6.1f} ", driven.log, field.id, hectares,
             driven.width_m, driven.worked_m * driven.width_m / (1e4 * hectares), 100 * driven.share,
             driven.along.degrees());
  const Plan plan = plan_field(field, machine, {}, settings_for(Aim::kWholeCost), 1);
  const auto planned = main_direction(plan);
  const double off_deg = planned ? angle_between(*planned, driven.along).degrees() : 0;
  const auto as_driven = cheapest_along(field, machine, plan, driven.along);
  const bool near = off_deg <= kNear_deg;
  const bool cheaper = !as_driven || price_of(plan) <= price_of(*as_driven);
  fmt::print("{:6.1f} {:4.0f} {:9.2f} {:9.2f} {}\n", planned ? planned->degrees() : 0, off_deg,
             price_of(plan), as_driven ? price_of(*as_driven) : 0,
             near ? "near" : (cheaper ? "cheaper" : "DEARER"));
  if (!near)
    fmt::print("    planned  {}\n    driven   {}\n", figures_in_full(plan),
               as_driven ? figures_in_full(*as_driven) : "no track fits");
  return near || cheaper;
}

int run(double radius_m) {
  const std::optional<RealFields> fields = read_or_say();
  if (!fields) return 0;
  fmt::print("{:42} {:36} {:>6} {:>5} {:>5} {:>6} {:>6} {:>6} {:>4} {:>9} {:>9}\n", "log", "field", "ha",
             "w m", "times", "share", "driven", "plan", "off", "plan €", "driven €");
  std::size_t compared = 0, failed = 0;
  const auto compare = [&](const std::optional<std::pair<Field, Driven>>& one, const std::string& name) {
    if (!one) {
      fmt::print("{:42} on no curated field\n", name);
      return;
    }
    ++compared;
    failed += print_compared(one->first, one->second, radius_m) ? 0 : 1;
    std::fflush(stdout);
  };
  for (const std::string& name : real_logs()) compare(field_of(*fields, name), name);
  compare(field_of_folder(), "AgOpenGPS line");
  fmt::print("{} compared, {} planned in another direction that costs more than the one driven\n", compared,
             failed);
  return failed == 0 ? 0 : 1;
}

}  // namespace
}  // namespace tramline::testing

int main(int count, char** words) {
  try {
    return tramline::testing::run(count > 1 ? std::atof(words[1]) : tramline::testing::kUsualRadius_m);
  } catch (const tramline::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
