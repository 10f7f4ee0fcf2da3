#include "options/price_options.h"

#include "options/field_options.h"
#include "options/plan_options.h"

namespace tramline::app {

void add_price_options(CommandOptions& command, PriceOptions& o) {
  command
      .add_option("LINES", o.lines.file,
                  "The centre lines: any vector file, an export of 'tramline export', or a plan file.")
      .required();
  command.begin_group("Lines");
  command.add_option("--lines-layer", o.lines.layer, "Read this layer of LINES.")
      .takes("NAME")
      .shows_default("the only layer with lines");
  command
      .add_option("--lines-where", o.lines.where,
                  "Read only lines that match, such as \"field_id='mill-field'\".")
      .takes("FILTER")
      .shows_default("all lines");
  add_field_choice(command, o.field);
  command.option("--field").shows_default("that of a plan file; other lines need it");
  add_plan_options(command, o.plan);
  command.option("--width").shows_default("that of a plan file; other lines need it");
  command.option("--radius").shows_default("that of a plan file, else 6");
  command.option("--prices").shows_default("those of a plan file, else 0.02,0.10,1,5,5");
  command.option("--clearance").shows_default("that of a plan file, else 0");
  command.begin_group("Comparison");
  const Option compare = command.add_flag("--compare", o.compare,
                                          "Also plan the field, and report both plans and the differences.");
  for (const char* option : {"--strategy",
                             "--direction-tolerance",
                             "--prove",
                             "--decomposition",
                             "--short-edge",
                             "--merge",
                             "--cell-direction",
                             "--end-rule",
                             "--boundary",
                             "--avoid",
                             "--avoid-threshold",
                             "--avoid-room",
                             "--headlands",
                             "--obstacle-headlands",
                             "--ab",
                             "--guide",
                             "--curved",
                             "--tracks",
                             "--ab-anchor",
                             "--min-length"})
    command.option(option).needs(compare);
}

}  // namespace tramline::app
