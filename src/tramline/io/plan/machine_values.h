#pragma once
// How a machine turns and what its hours cost, as keys and values of the table `metadata`.

#include "tramline/io/geopackage/metadata.h"
#include "tramline/io/plan/plan_keys.h"
#include "tramline/model/machine.h"

namespace tramline::io {

/// What differs from the defaults.
void write_machine_values(const Machine& machine, const PlanKeyWriter& writer);

/// The inverse, where a file has the keys. Throw Error(kBadInput) naming the key at fault.
void apply_turning(const Metadata& metadata, const PlanKeyReader& reader, Machine& machine);
void apply_rates(const Metadata& metadata, const PlanKeyReader& reader, Machine& machine);

}  // namespace tramline::io
