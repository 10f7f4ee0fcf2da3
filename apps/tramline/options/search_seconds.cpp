#include "options/search_seconds.h"

namespace tramline::app {

void add_seconds_option(CommandOptions& command, std::optional<double>& seconds) {
  command
      .add_option(
          "--seconds", seconds,
          "End the search for a field after this many seconds, with the best plan found so far, which is "
          "marked as cut short; Ctrl-C does the same to the search for a single field.")
      .takes("S")
      .positive()
      .shows_default("no limit");
}

}  // namespace tramline::app
