#include <fmt/format.h>

#include "exports/export_parts.h"
#include "exports/export_runs.h"
#include "output/output_target.h"
#include "report/line_card_pages.h"

namespace tramline::app {

void run_line_card_export(const ExportOptions& options) {
  require_writable(options.output, "--output", {".pdf"}, options.plans);
  const LineCardReport report =
      write_line_cards(plan_paths(options), options.id, options.tolerance_m, options.output);
  print_report(
      options,
      fmt::format("{}: line card, {} field{}\n", options.output, report.cards, report.cards == 1 ? "" : "s") +
          count_row("lines", report.lines),
      {{"plans", options.plans},
       {"fields", report.cards},
       {"file", options.output},
       {"format", "line card"},
       {"lines", report.lines}});
}

}  // namespace tramline::app
