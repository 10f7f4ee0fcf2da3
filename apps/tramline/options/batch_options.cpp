#include "options/batch_options.h"

#include "options/field_options.h"
#include "options/plan_options.h"
#include "tramline/geometry/error.h"

namespace tramline::app {

void add_batch_options(CommandOptions& command, BatchRequest& request, bool& resume) {
  command.add_option("PARCELS", request.field.file, "The fields: any vector file, as of 'tramline plan'.")
      .required();
  command.begin_group("Field");
  command.add_option("--layer", request.field.layer, "Read this layer.")
      .takes("NAME")
      .shows_default("the only layer with polygons");
  command
      .add_option("--where", request.field.where, "Read only features that match, such as \"crop='wheat'\".")
      .takes("FILTER")
      .shows_default("all features");
  add_crs_option(command, request.field);
  add_plan_options(command, request.plan, PlanDefaults::kWhole);
  command.begin_group("Output");
  command.add_option("-o,--output", request.folder, "Write into this folder, which is made.")
      .takes("FOLDER")
      .required();
  command
      .add_option("--chunk", request.fields_per_chunk, "Features of a chunk: what a run that is ended loses.")
      .takes("N")
      .in_range(1, 100000)
      .shows_default("200");
  command.add_flag("--resume", resume,
                   "Go on with the batch in the folder: finished chunks are not planned again.");
}

void take_batch_defaults(const CommandOptions& command, BatchRequest& request) {
  take_conventions(command, request.plan);
  take_whole_plan(command, request.plan);
}

}  // namespace tramline::app
