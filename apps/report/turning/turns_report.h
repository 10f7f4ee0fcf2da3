#pragma once
// The manoeuvres of a machine between neighbouring tracks: as JSON, and as a table for people.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tramline/turns/turn_table.h"

namespace tramline::app {

struct TurnsReport {
  Machine machine;
  TurnTableSettings settings;
  std::vector<TurnRow> rows;  ///< of turn_table()
};

/// The object of `turns --json` (docs/json.md), with all manoeuvres.
nlohmann::ordered_json turns_json(const TurnsReport& report);

enum class ShownTurns { kQuickest, kAll };
/// The quickest manoeuvre to each track, or all of them with how far they get back over the tracks, and what
/// follows from them in a few sentences.
std::string turns_table(const TurnsReport& report, ShownTurns shown);
/// The same rows with a heading, as CSV.
std::string turns_csv(const TurnsReport& report);

/// "Adjacent tracks need 16.9 m: 6 passes.", a sentence each. What is compared is the quickest manoeuvre to
/// each track.
std::vector<std::string> turns_summary(const TurnsReport& report);

/// "unequal arcs" and "3 passes", for people.
std::string kind_text(ManoeuvreKind kind);
std::string passes_text(int passes);

}  // namespace tramline::app
