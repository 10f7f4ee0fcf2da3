#include "tramline/io/plan/machine_values.h"

#include "tramline/geometry/error.h"
#include "tramline/model/rate_values.h"
#include "tramline/model/turning_values.h"

namespace tramline::io {
namespace {

std::string machine_key(const char* key) { return std::string("machine.") + key; }

/// All of them where any differs from the default: those who read the file need not know the defaults.
void write_turning(const Turning& turning, const PlanKeyWriter& writer) {
  if (turning == Turning{}) return;
  writer(machine_key(kReverseKey), turning.reverse);
  writer(machine_key(kImplementKey), std::string(name(turning.implement)));
  for (const TurningNumber& number : kTurningNumbers) writer(machine_key(number.key), turning.*number.value);
}

Turning read_turning(const PlanKeyReader& reader) {
  Turning out;
  reader(machine_key(kReverseKey), out.reverse);
  const std::string implement = machine_key(kImplementKey);
  const auto coupling = coupling_named(reader.text(implement));
  if (!coupling) throw reader.wrong(implement, "mounted or towed");
  out.implement = *coupling;
  for (const TurningNumber& number : kTurningNumbers) {
    const std::string key = machine_key(number.key);
    reader(key, out.*number.value);
    if (!fault_of(number, out.*number.value).empty()) throw reader.wrong(key, "a value that machines have");
  }
  if (!drawbar_fault(out).empty())
    throw reader.wrong(machine_key(kDrawbarKey),
                       "a length of a towed implement's drawbar, 0 for a mounted one");
  return out;
}

/// Those that differ from what is usual for the operation.
void write_rates(const Rates& rates, const PlanKeyWriter& writer) {
  if (rates == Rates{}) return;
  writer(machine_key(kOperationKey), std::string(name(rates.operation)));
  for (const RateNumber& number : kRateNumbers)
    if (rates.*number.value >= 0) writer(machine_key(number.key), rates.*number.value);
}

Rates read_rates(const PlanKeyReader& reader, const Metadata& metadata) {
  Rates out;
  const std::string operation = machine_key(kOperationKey);
  const auto named = operation_named(reader.text(operation));
  if (!named) throw reader.wrong(operation, "an operation that this version of tramline knows");
  out.operation = *named;
  for (const RateNumber& number : kRateNumbers) {
    const std::string key = machine_key(number.key);
    if (!metadata.contains(key)) continue;
    reader(key, out.*number.value);
    if (!fault_of(number, out.*number.value).empty()) throw reader.wrong(key, "a value that machines have");
  }
  return out;
}

}  // namespace

void write_machine_values(const Machine& machine, const PlanKeyWriter& writer) {
  write_turning(machine.turning, writer);
  write_rates(machine.rates, writer);
}

void apply_turning(const Metadata& metadata, const PlanKeyReader& reader, Machine& machine) {
  if (metadata.contains(machine_key(kReverseKey))) machine.turning = read_turning(reader);
}

void apply_rates(const Metadata& metadata, const PlanKeyReader& reader, Machine& machine) {
  if (metadata.contains(machine_key(kOperationKey))) machine.rates = read_rates(reader, metadata);
}

}  // namespace tramline::io
