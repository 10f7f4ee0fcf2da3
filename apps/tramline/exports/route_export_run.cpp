#include <fmt/format.h>

#include <iterator>
#include <string>

#include "exports/export_parts.h"
#include "exports/export_runs.h"
#include "output/output_target.h"
#include "tramline/geometry/error.h"
#include "tramline/io/export/export_plan.h"

namespace tramline::app {

void run_route_export(const ExportOptions& options, io::RouteFormat format) {
  require_writable(options.output, "--output",
                   {".gpx", ".plan", ".waypoints", ".kmz", ".yaml", ".yml", ".json"}, options.plans);
  if (options.plans.size() > 1)
    throw bad_input(fmt::format("a file holds the route of one plan, not of {}; export them one by one",
                                options.plans.size()));
  const io::RouteReport report = io::export_route(
      {options.plans.front(), options.output, format, options.machine, options.tolerance_m, options.id});
  constexpr double kKilometre_m = 1000;
  std::string table =
      fmt::format("{}: field {}, {}\n", options.output, report.field_id, name(report.format)) +
      (report.gaps > 0 ? count_row("gaps", report.gaps)
                       : count_row("points", report.points) +
                             fmt::format("  {:<18}{:>8.3f} km\n", "route", report.length_m / kKilometre_m));
  for (const std::string& note : report.notes) fmt::format_to(std::back_inserter(table), "note: {}\n", note);
  print_report(options, table,
               {{"plan", options.plans.front()},
                {"field_id", report.field_id},
                {"tolerance_m", options.tolerance_m},
                {"file", options.output},
                {"format", name(report.format)},
                {"points", report.points},
                {"route_m", report.length_m},
                {"gaps", report.gaps},
                {"notes", report.notes}});
}

}  // namespace tramline::app
