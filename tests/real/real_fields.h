#pragma once
// Real fields as test material: read, planned and verified.

#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tramline/geodesy/crs.h"
#include "tramline/geometry/error.h"
#include "tramline/model/field.h"
#include "tramline/model/plan.h"
#include "tramline/model/raw_feature.h"

namespace tramline::testing {

/// The folder with the real data: $TRAMLINE_DATA, or shared/data beside the source tree.
std::string real_data_folder();

/// The curated fields; nullopt where the folder is absent.
struct RealFields {
  std::string file;
  RawDataset dataset;
  const std::vector<RawFeature>& features() const { return dataset.layers.front().features; }
};
std::optional<RealFields> read_real_fields();
/// All fields, of which the curated ones are a choice; nullopt where the folder is absent.
std::optional<RealFields> read_all_real_fields();
/// Why a test is skipped, and what to do.
std::string no_real_fields();
/// The curated fields; where the folder is absent, it says so on standard output.
std::optional<RealFields> read_or_say();

/// The fields that a feature of the dataset makes. Throws Error(kBadInput) where it makes none. `crs` is the
/// dataset's; it serves one thread at a time.
std::vector<Field> admitted(const RealFields& fields, const Crs& crs, const RawFeature& feature);

/// What `look` makes of every field, in file order. `look` is called from several threads.
template <class Look>
auto for_each_field(const RealFields& fields, const Look& look) {
  using Seen = decltype(look(std::declval<const Field&>()));
  std::vector<std::vector<Seen>> by_feature(fields.features().size());
  tbb::parallel_for(std::size_t{0}, by_feature.size(), [&](std::size_t i) {
    thread_local const Crs crs(fields.dataset.layers.front().crs);  // one serves one thread at a time
    for (const Field& field : admitted(fields, crs, fields.features()[i]))
      by_feature[i].push_back(look(field));
  });
  std::vector<Seen> out;
  for (std::vector<Seen>& parts : by_feature) std::move(parts.begin(), parts.end(), std::back_inserter(out));
  return out;
}

/// What the verifier finds, a sentence each; empty where all is well.
std::vector<std::string> faults_of(const Plan& plan);
/// The same of a plan file: also where it contradicts itself, and whether its field is that of the input.
std::vector<std::string> faults_of_file(const std::string& file, const Field& input);

/// The machine of a program's words WIDTH RADIUS KIND; nullopt, with the usage on stderr, where they are none
/// of these. The kinds `forward` and `reversing` are bars at the axle, `carrying` is a tractor that reverses,
/// with an implement behind it that takes 2 m to be lifted and lowered, and `towing` one with a drawbar.
std::optional<Machine> machine_in_words(int count, char** words, const char* usage);

/// Adds the failure of a run to the faults; that a field was refused is not a fault.
void add_failure(const Error& error, std::vector<std::string>& faults);
/// Prints a line for each fault of a field.
void print_faults(const Field& field, const std::vector<std::string>& faults);

/// Versleijen table 2: 1 least overlap, 2 least uncovered, 3 fewest turns.
Objective scenario(int number);

/// How one field fared under one scenario and end rule.
struct Outcome {
  std::string field_id;
  std::string refused;                  ///< why there is no plan; empty when there is one
  std::vector<std::string> violations;  ///< what the verifier found
  double field_m2 = 0, overlap_pct = 0, uncovered_pct = 0, seconds = 0;
  int turns = 0, pieces = 0, directions_tried = 0;
  std::size_t obstacles = 0;
};

/// Admits, plans (w = 3, r = 6, merge 15, decomposition 205, one thread), writes the plan file, reads
/// it back and verifies that, also against a fresh admission of the input. One outcome per part.
/// `scratch` is a file name of its own for the plan; `crs` as above.
std::vector<Outcome> plan_and_verify(const RealFields& fields, const Crs& crs, const RawFeature& feature,
                                     int scenario_number, EndRule end_rule, const std::string& scratch);

}  // namespace tramline::testing
