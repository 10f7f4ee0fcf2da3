#include "report/check_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "request/field_key.h"

namespace tramline::app {
namespace {

/// Two decimals, and never "-0.00".
std::string rounded(double value) { return fmt::format("{:.2f}", std::round(value * 100) / 100 + 0.0); }

class Table {
 public:
  explicit Table(bool recomputed) : recomputed_(recomputed) { row("", "stored", "recomputed"); }
  void number(const char* what, double stored, double found) { row(what, rounded(stored), rounded(found)); }
  void count(const char* what, int stored, int found) {
    row(what, std::to_string(stored), std::to_string(found));
  }
  const std::string& text() const { return text_; }

 private:
  void row(const char* what, const std::string& stored, const std::string& found) {
    fmt::format_to(std::back_inserter(text_), "  {:<18}{:>14}{:>14}\n", what, stored,
                   recomputed_ ? found : "-");
  }
  bool recomputed_;
  std::string text_;
};

std::string figures(const Plan& plan, const check::Verdict& verdict) {
  const Tally& stored = plan.tally;
  const Tally& found = verdict.recomputed;
  Table table(verdict.complete);
  table.number("overlap, m²", stored.overlap_m2, found.overlap_m2);
  table.number("uncovered, m²", stored.uncovered_m2, found.uncovered_m2);
  table.number("worked, m²", stored.worked_m2, found.worked_m2);
  table.number("track length, m", stored.track_length_m, found.track_length_m);
  table.count("tracks", stored.pieces, found.pieces);
  table.count("turns", stored.turns, found.turns);
  table.count("stops", stored.stops, found.stops);
  table.number("cost", plan.cost, cost(plan.objective, found));
  return table.text();
}

nlohmann::ordered_json to_json(const check::Violation& violation) {
  return {{"rule", name(violation.rule)},
          {"what", violation.what},
          {"x_m", violation.at.x},
          {"y_m", violation.at.y},
          {"amount", violation.amount}};
}

nlohmann::ordered_json to_json(const Tally& tally) {
  return {{"overlap_m2", tally.overlap_m2}, {"uncovered_m2", tally.uncovered_m2},
          {"worked_m2", tally.worked_m2},   {"turns", tally.turns},
          {"stops", tally.stops},           {"crossings", tally.crossings},
          {"tracks", tally.pieces},         {"track_length_m", tally.track_length_m}};
}

/// "not verified: proof (bound, one_direction_bound), frame, settings (17)": names by what they belong to.
/// Many of one kind are counted; JSON has them all.
std::string not_verified_line(const std::vector<std::string>& names) {
  constexpr std::size_t kMany = 4;
  const auto group_of = [](const std::string& name) { return name.substr(0, name.find('.')); };
  std::string out;
  for (std::size_t i = 0; i < names.size();) {
    const std::string group = group_of(names[i]);
    std::vector<std::string> members;
    for (; i < names.size() && group_of(names[i]) == group; ++i)
      if (names[i] != group) members.push_back(names[i].substr(group.size() + 1));
    out += (out.empty() ? "" : ", ") + group;
    if (members.size() > kMany)
      out += fmt::format(" ({})", members.size());
    else if (!members.empty())
      out += fmt::format(" ({})", fmt::join(members, ", "));
  }
  return out.empty() ? out : "not verified: " + out + "\n";
}

/// "radius: …, at x 1.000 m, y 2.000 m"
std::string sentence(const check::Violation& violation) {
  return fmt::format("{}: {}, at x {:.3f} m, y {:.3f} m\n", name(violation.rule), violation.what,
                     violation.at.x, violation.at.y);
}

/// The first of them, and how many more there are; JSON has them all.
std::string findings_text(const std::vector<check::Violation>& findings) {
  constexpr std::size_t kPrinted = 20;
  std::string out;
  for (std::size_t i = 0; i < std::min(kPrinted, findings.size()); ++i)
    out += "finding: " + sentence(findings[i]);
  if (findings.size() > kPrinted)
    out += fmt::format("{} more findings; --json lists them\n", findings.size() - kPrinted);
  return out;
}

nlohmann::ordered_json to_json(const std::vector<check::Violation>& violations) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const check::Violation& violation : violations) out.push_back(to_json(violation));
  return out;
}

}  // namespace

std::string check_table(const std::string& plan_file, const Plan& plan, const check::Verdict& verdict) {
  std::string out = fmt::format("{}: field {}, {} subfields, {} tracks\n", plan_file, plan.field.id,
                                plan.subfields.size(), plan.pieces.size());
  out += figures(plan, verdict);
  for (const check::Violation& violation : verdict.violations) out += sentence(violation);
  out += findings_text(verdict.findings);
  out += not_verified_line(verdict.not_verified);
  if (verdict.violations.empty() && !plan.proof.prices.cells.empty())
    out +=
        fmt::format("proof holds: no plan of tracks costs less than {:.2f}, further subfields not counted\n",
                    std::max(0.0, plan.proof.prices.bound));
  if (verdict.violations.empty()) return out + "plan holds\n";
  return out + fmt::format("{} violation{}\n", verdict.violations.size(),
                           verdict.violations.size() == 1 ? "" : "s");
}

nlohmann::ordered_json check_json(const std::string& plan_file, const Plan& plan,
                                  const check::Verdict& verdict) {
  nlohmann::ordered_json recomputed;
  if (verdict.complete) recomputed = to_json(verdict.recomputed);
  nlohmann::ordered_json out = {{"plan", plan_file},
                                {"field_id", plan.field.id},
                                {"key", field_key(plan.field)},
                                {"ok", verdict.holds()},
                                {"complete", verdict.complete},
                                {"violations", to_json(verdict.violations)},
                                {"findings", to_json(verdict.findings)},
                                {"recomputed", recomputed},
                                {"stored", to_json(plan.tally)},
                                {"not_verified", verdict.not_verified}};
  if (!plan.proof.prices.cells.empty() && verdict.holds()) out["proven_bound"] = plan.proof.prices.bound;
  return out;
}

}  // namespace tramline::app
