#include "coverage/random_log.h"

#include <cmath>

#include "coverage/logs.h"

namespace tramline::testing_logs {

WorkLog random_log(std::mt19937_64& random) {
  const auto chance = [&](double share) { return std::uniform_real_distribution<>(0, 1)(random) < share; };
  std::normal_distribution<> noise(0, 0.05);
  const bool says_work = chance(0.5), has_sections = chance(0.5), late = chance(0.5), untimed = chance(0.2),
             two_units = chance(0.2), no_width_at_first = chance(0.2), copies = chance(0.2);
  WorkLog out;
  out.name = "random";
  out.clock = Clock::kOther;
  out.booms = {boom(4, 6), boom(4, 8), boom(4, copies ? 100 : 4)};
  const int fixes = std::uniform_int_distribution<>(2, 160)(random);
  const int silent = std::uniform_int_distribution<>(0, fixes)(random);
  for (int i = 0; i < fixes; ++i) {
    const int lane = i / 30, along = lane % 2 == 0 ? i % 30 : 29 - i % 30;
    Fix fix = testing_logs::fix(i + (chance(0.02) ? 30 : 0), {2.0 * along + noise(random), 5.0 * lane + 2});
    fix.work = WorkState::kUnknown;
    fix.boom = no_width_at_first && i < silent ? -1 : chance(0.1) ? (chance(0.5) ? 1 : 2) : 0;
    if (says_work && i >= silent) fix.work = chance(0.8) ? WorkState::kOn : WorkState::kOff;
    if (has_sections && chance(0.9))
      fix = with_sections(fix, i < silent ? "0000" : chance(0.9) ? "1111" : "0110");
    if (late && chance(0.03)) fix.time_s -= 3;
    if (untimed && chance(0.2)) fix.time_s = std::nan("");
    if (two_units && i % 2 == 1) {
      fix.unit = 1;
      fix.position.y += 40;
    }
    fix.record = static_cast<std::size_t>(i) + 1;
    out.fixes.push_back(fix);
  }
  return out;
}

}  // namespace tramline::testing_logs
