#pragma once
// What the chunks of a batch come to.

#include <nlohmann/json.hpp>

#include "batch/batch_folder.h"

namespace tramline::app {

/// Reads the lines of all chunks, one at a time, and writes fields.csv, refused.csv, histogram.png and
/// summary.json. Returns what summary.json says: {fields, planned, refused, skipped, area_m2, overlap_m2,
/// uncovered_m2, track_length_m} and, with whole routes, {hours, litres, euros}. Throws Error(kBadInput) for
/// a line that is damaged, and Error(kFailure). Memory: one number a field. O(fields).
nlohmann::ordered_json write_summary(const BatchFolder& folder, long long chunks);

}  // namespace tramline::app
