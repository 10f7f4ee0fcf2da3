#include "tramline/coverage/plausible.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace tramline::coverage {
namespace {

double width_m(const Section& section) { return section.left_m - section.right_m; }

double sum_m(const Boom& boom) {
  double sum = 0;
  for (const Section& section : boom) sum += width_m(section);
  return sum;
}

Boom widest_alone(const Boom& boom) {
  double widest = 0;
  for (const Section& section : boom) widest = std::max(widest, width_m(section));
  return {{widest / 2, -widest / 2}};
}

void mend_widths(WorkLog& log) {
  std::vector<char> mended(log.booms.size(), 0);
  for (std::size_t i = 0; i < log.booms.size(); ++i) {
    Boom& boom = log.booms[i];
    if (boom.size() < 2 || sum_m(boom) <= kWidestMachine_m) continue;
    const Boom one = widest_alone(boom);
    log.notes.push_back(fmt::format("{} widths that add up to {:g} m are taken for one of {:g} m",
                                    boom.size(), sum_m(boom), width_m(one.front())));
    boom = one;
    mended[i] = 1;
  }
  for (Fix& fix : log.fixes)
    if (fix.boom >= 0 && mended[static_cast<std::size_t>(fix.boom)] != 0 && fix.has_sections) {
      // One section works where any did.
      const bool any = fix.sections.any();
      fix.sections.reset();
      fix.sections[0] = any;
    }
}

void mend_sections(WorkLog& log) {
  const auto says = [](const Fix& fix) { return fix.has_sections && fix.work == WorkState::kOn; };
  const auto works = [](const Fix& fix) { return fix.has_sections && fix.sections.any(); };
  if (std::none_of(log.fixes.begin(), log.fixes.end(), says) ||
      std::any_of(log.fixes.begin(), log.fixes.end(), works))
    return;
  log.notes.emplace_back(
      "no section ever works, although the machine does: the states of sections are ignored");
  for (Fix& fix : log.fixes) fix.has_sections = false;
}

}  // namespace

WorkLog plausible(WorkLog log) {
  mend_widths(log);
  mend_sections(log);
  return log;
}

}  // namespace tramline::coverage
