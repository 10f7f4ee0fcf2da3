#include "tramline/coverage/drive/log_sanity.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace tramline::coverage {
namespace {

double width_m(const Section& section) { return section.left_m - section.right_m; }

/// Of the sections together; what two of them work counts once.
double worked_m(Boom boom) {
  std::stable_sort(boom.begin(), boom.end(),
                   [](const Section& a, const Section& b) { return a.left_m > b.left_m; });
  double sum = 0, right_m = std::numeric_limits<double>::infinity();
  for (const Section& section : boom) {
    sum += std::max(0.0, std::min(section.left_m, right_m) - section.right_m);
    right_m = std::min(right_m, section.right_m);
  }
  return sum;
}

Boom widest_alone(const Boom& boom) {
  double widest = 0;
  for (const Section& section : boom) widest = std::max(widest, width_m(section));
  return {{widest / 2, -widest / 2}};
}

void mend_widths(WorkLog& log) {
  std::vector<char> changed(log.booms.size(), 0);
  for (std::size_t i = 0; i < log.booms.size(); ++i) {
    Boom& boom = log.booms[i];
    const std::optional<Boom> one = mended(boom);
    if (!one) continue;
    log.notes.push_back(fmt::format("{} widths that add up to {:g} m are taken as one of {:g} m", boom.size(),
                                    worked_m(boom), width_m(one->front())));
    boom = *one;
    changed[i] = 1;
  }
  for (Fix& fix : log.fixes)
    if (fix.boom >= 0 && changed[static_cast<std::size_t>(fix.boom)] != 0) fix = with_one_section(fix);
}

void mend_sections(WorkLog& log) {
  SectionTrust trust;
  for (const Fix& fix : log.fixes) trust.add(fix);
  if (!trust.ignored()) return;
  log.notes.emplace_back(kSectionsIgnored);
  for (Fix& fix : log.fixes) fix.has_sections = false;
}

}  // namespace

std::optional<Boom> mended(const Boom& boom) {
  if (boom.size() < 2 || worked_m(boom) <= kWidestMachine_m) return std::nullopt;
  return widest_alone(boom);
}

Fix with_one_section(Fix fix) {
  if (!fix.has_sections) return fix;
  const bool any = fix.sections.any();
  fix.sections.reset();
  fix.sections[0] = any;
  return fix;
}

void SectionTrust::add(const Fix& fix) {
  if (!fix.has_sections) return;
  says_ = says_ || fix.work == WorkState::kOn;
  works_ = works_ || fix.sections.any();
}

WorkLog log_without_faults(WorkLog log) {
  mend_widths(log);
  mend_sections(log);
  return log;
}

}  // namespace tramline::coverage
