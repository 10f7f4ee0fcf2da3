#include "tramline/model/machine.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace tramline {
namespace {

/// What is usual for an operation: prices of docs/prices.md, speeds near the typical ones of ASAE D497.7
/// (table 3), fuel near Iowa State University Extension A3-27 (gallons per acre). In general nobody knows
/// what is worked, so input and margin are about the means of those from seeding to harvest.
struct Usual {
  Operation operation;
  const char* name;
  double speed_mps;
  double price_per_hour;
  double fuel_l_per_ha;
  double input_price_per_ha;
  double margin_per_ha;
  bool standing_crop;
};

constexpr std::array<Usual, 9> kUsual{{
    {Operation::kGeneral, "general", 2.5, 90, 5, 50, 700, false},
    {Operation::kSeeding, "seeding", 2.2, 90, 3.5, 110, 1000, false},
    {Operation::kSpraying, "spraying", 2.9, 120, 1, 60, 400, true},
    {Operation::kSpreading, "spreading", 3.1, 100, 1.5, 150, 500, true},
    {Operation::kTillage, "tillage", 3.1, 110, 6, 0, 100, false},
    {Operation::kMowing, "mowing", 3.1, 80, 5.5, 0, 700, true},
    {Operation::kHarvest, "harvest", 1.4, 250, 10, 0, 1500, true},
    {Operation::kWeeding, "robot weeding", 1, 15, 0, 0, 800, true},
    {Operation::kDrone, "drone", 5, 60, 0, 60, 400, false},
}};
constexpr double kUsualFuelPrice = 1.2;  // euros per litre
/// Euros for the soil that is pressed and the care it takes; the time counts besides, unlike in
/// Objective::stop.
constexpr double kUsualStopPrice = 1;

const Usual& usual_of(Operation operation) {
  for (const Usual& usual : kUsual)
    if (usual.operation == operation) return usual;
  return kUsual.front();
}

void fill_in(double& value, double usual) {
  if (value < 0) value = usual;
}

}  // namespace

const char* name(Operation operation) { return usual_of(operation).name; }

std::optional<Operation> operation_named(std::string_view word) {
  for (const Usual& usual : kUsual)
    if (word == usual.name) return usual.operation;
  return std::nullopt;
}

double usual_speed_mps(Operation operation) { return usual_of(operation).speed_mps; }

bool works_standing_crop(Operation operation) { return usual_of(operation).standing_crop; }

Rates rates_of(const Machine& machine) {
  const Usual& usual = usual_of(machine.rates.operation);
  constexpr double kHaPerHour = 3600 / 1e4;  // in a m²/s
  Rates out = machine.rates;
  fill_in(out.price_per_hour, usual.price_per_hour);
  fill_in(out.fuel_l_per_h,
          usual.fuel_l_per_ha * machine.width_m * machine.turning.working_speed_mps * kHaPerHour);
  fill_in(out.fuel_price, kUsualFuelPrice);
  fill_in(out.sections, 1);
  fill_in(out.input_price_per_ha, usual.input_price_per_ha);
  fill_in(out.margin_per_ha, usual.margin_per_ha);
  fill_in(out.price_per_stop, kUsualStopPrice);
  return out;
}

double corner_swing_m(const Machine& machine) {
  assert(machine.width_m > 0);
  const Turning& turning = machine.turning;
  const double radius_m = machine.radius_m, half_m = 0.5 * machine.width_m;
  double farthest_m = std::hypot(radius_m + 0.5 * turning.vehicle_width_m, turning.front_overhang_m);
  if (turning.implement == Coupling::kMounted) {
    const double from_m = turning.implement_offset_m, to_m = from_m + turning.rear_overhang_m;
    farthest_m =
        std::max(farthest_m, std::hypot(radius_m + half_m, std::max(std::abs(from_m), std::abs(to_m))));
  }
  return std::max(0.0, farthest_m - (radius_m + half_m));
}

const char* name(Coupling coupling) { return coupling == Coupling::kTowed ? "towed" : "mounted"; }

std::optional<Coupling> coupling_named(std::string_view word) {
  for (const Coupling coupling : {Coupling::kMounted, Coupling::kTowed})
    if (word == name(coupling)) return coupling;
  return std::nullopt;
}

}  // namespace tramline
