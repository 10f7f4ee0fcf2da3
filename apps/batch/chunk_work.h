#pragma once
// The work on one chunk of fields.

#include <cstddef>
#include <string>

#include "batch/batch_folder.h"
#include "request/asked_plans.h"
#include "request/field_input.h"
#include "request/plan_request.h"

namespace tramline::app {

/// What all chunks of a batch have in common.
struct ChunkRequest {
  FieldOptions field;  ///< of all fields, without the features
  PlanOptions plan;
  AskedPlans asked;  ///< made of `plan`
};

struct ChunkCounts {
  std::size_t planned = 0, refused = 0;
};

/// Plans the fields of `features` and writes plans and lines of the chunk. A field that cannot be planned has
/// a line that says why. Depends on the features and the request alone, on no number of threads. Throws
/// Error(kFailure) where a file cannot be written. `features` has one layer at most.
ChunkCounts work_on_chunk(const ChunkRequest& request, RawDataset features, const BatchFolder& folder,
                          long long chunk);

}  // namespace tramline::app
