#include <fmt/format.h>

#include <cmath>

#include "tramline/geometry/error.h"
#include "tramline/io/geopackage/key_values.h"
#include "tramline/io/geopackage/local_crs.h"
#include "tramline/io/plan/path_text.h"
#include "tramline/io/plan/plan_layers.h"
#include "tramline/io/plan/route_rows.h"
#include "tramline/model/plain_zero.h"
#include "tramline/model/rate_values.h"

namespace tramline::io {
namespace {

constexpr const char* kOrder = "settings.route.order";
constexpr const char* kPasses = "settings.route.passes";
constexpr const char* kSequence = "settings.route.sequence";
constexpr const char* kCorners = "settings.route.corners";
constexpr const char* kStart = "settings.route.start";
constexpr const char* kEnd = "settings.route.end";
constexpr const char* kBound = "route.bound_s";
constexpr const char* kStop = "route.stop_s";  // not in plans whose bounds are of the time alone
constexpr const char* kNodePrices = "route.node_prices_s";
constexpr const char* kOverWorked = "route.over_worked_m";
constexpr const char* kOverUnworked = "route.over_unworked_m";
constexpr const char* kOverTracks = "route.over_tracks_m";
constexpr const char* kHours = "whole_cost.hours";
constexpr const char* kLitres = "whole_cost.litres";
constexpr const char* kEuros = "whole_cost.euros";

std::string rate_key(const char* key) { return std::string("whole_cost.rates.") + key; }

void write_gate(const char* key, const std::optional<Point>& gate, Point offset, Metadata& out) {
  if (gate) out[key] = points_text({*gate}, offset);
}

class Values {
 public:
  Values(const Metadata& metadata, const std::filesystem::path& file)
      : metadata_(metadata), read_(metadata, file, kPlanFile) {}

  bool has(const char* key) const { return metadata_.contains(key); }
  double number(const std::string& key) const {
    double out = 0;
    read_(key, out);
    return out;
  }

  double rate(const RateNumber& number_of) const {
    const std::string key = rate_key(number_of.key);
    const double out = number(key);
    if (!fault_of(number_of, out).empty()) throw read_.wrong(key, "a value that machines have");
    return out;
  }
  Operation operation() const {
    const std::string key = rate_key(kOperationKey);
    const auto out = operation_named(read_.text(key));
    if (!out) throw read_.wrong(key, "an operation that this version of tramline knows");
    return *out;
  }

  template <class Choice>
  void word(const char* key, std::optional<Choice> (*named)(std::string_view), Choice& into) const {
    if (!has(key)) return;
    const std::optional<Choice> choice = named(read_.text(key));
    if (!choice) throw read_.wrong(key, "a word this version of tramline knows");
    into = *choice;
  }

  void gate(const char* key, Point offset, std::optional<Point>& into) const {
    if (!has(key)) return;
    const std::vector<Point> points = points_from_text(read_.text(key), offset, read_.place_of(key));
    if (points.size() != 1) throw read_.wrong(key, "one point");
    into = points.front();
  }

  std::vector<double> numbers(const char* key) const {
    std::vector<double> out;
    read_.parse(key, [&](const nlohmann::json& list) {
      if (!list.is_array()) throw nlohmann::json::other_error::create(0, "no list", nullptr);
      for (const nlohmann::json& item : list) {
        out.push_back(item.get<double>());
        if (!std::isfinite(out.back())) throw nlohmann::json::other_error::create(0, "not finite", nullptr);
      }
    });
    return out;
  }

 private:
  const Metadata& metadata_;
  KeyReader read_;
};

void write_settings(const Plan& plan, Metadata& out) {
  const RouteSettings& settings = plan.settings.route;
  const RouteSettings plain;
  if (settings.order != plain.order) out[kOrder] = name(settings.order);
  if (settings.passes != plain.passes) out[kPasses] = name(settings.passes);
  if (settings.sequence != plain.sequence) out[kSequence] = name(settings.sequence);
  if (settings.corners != plain.corners) out[kCorners] = name(settings.corners);
  const Point offset = offset_of(plan.field.frame);
  write_gate(kStart, settings.start, offset, out);
  write_gate(kEnd, settings.end, offset, out);
}

void write_cost(const Plan& plan, const KeyWriter& writer) {
  const WholeCost cost = whole_cost(plan);
  writer(kHours, cost.time_s() / 3600);
  writer(kLitres, cost.fuel_l);
  writer(kEuros, cost.euros());
  const Rates rates = rates_of(plan.machine);
  writer(rate_key(kOperationKey), std::string(name(rates.operation)));
  for (const RateNumber& number : kRateNumbers) writer(rate_key(number.key), rates.*number.value);
}

}  // namespace

void write_route_values(const Plan& plan, Metadata& out) {
  write_settings(plan, out);
  if (!plan.route.planned()) return;
  const KeyWriter writer(out);
  const Route& route = plan.route;
  writer(kBound, route.proof.bound_s);
  writer(kStop, route.proof.stop_s);
  nlohmann::json prices = nlohmann::json::array();
  for (const double price_s : route.proof.node_prices_s) prices.push_back(plain_zero(price_s));
  out[kNodePrices] = prices.dump();
  writer(kOverWorked, route.over_worked_m);
  writer(kOverUnworked, route.over_unworked_m);
  writer(kOverTracks, route.over_tracks_m);
  write_cost(plan, writer);
}

void apply_route_values(const Metadata& metadata, const std::filesystem::path& file, Plan& plan) {
  const Values values(metadata, file);
  RouteSettings& settings = plan.settings.route;
  values.word(kOrder, track_order_named, settings.order);
  values.word(kPasses, pass_time_named, settings.passes);
  values.word(kSequence, pass_sequence_named, settings.sequence);
  values.word(kCorners, pass_corners_named, settings.corners);
  const Point offset = offset_of(plan.field.frame);
  values.gate(kStart, offset, settings.start);
  values.gate(kEnd, offset, settings.end);
  if (!values.has(kBound)) return;
  plan.route.proof.bound_s = values.number(kBound);
  if (values.has(kStop)) plan.route.proof.stop_s = values.number(kStop);
  plan.route.proof.node_prices_s = values.numbers(kNodePrices);
  plan.route.over_worked_m = values.number(kOverWorked);
  plan.route.over_unworked_m = values.number(kOverUnworked);
  plan.route.over_tracks_m = values.number(kOverTracks);
}

std::optional<StatedCost> stated_cost_in(const Metadata& metadata, const std::filesystem::path& file) {
  const Values values(metadata, file);
  if (!values.has(kEuros)) return std::nullopt;
  StatedCost out;
  out.hours_h = values.number(kHours);
  out.litres = values.number(kLitres);
  out.euros = values.number(kEuros);
  out.rates.operation = values.operation();
  for (const RateNumber& number : kRateNumbers) out.rates.*number.value = values.rate(number);
  return out;
}

}  // namespace tramline::io
