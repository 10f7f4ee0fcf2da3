#include "tramline/planner/enterable_gaps.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "tramline/planner/for_each_index.h"

namespace tramline {
namespace {

std::optional<GapGroup> with_lines(const Gap& gap, const RepairGround& ground) {
  GapGround part = ground_of({gap.shape}, ground);
  std::optional<GapChoice> choice = chosen_lines(part, ground, GapEffort::kLook);
  if (!choice) choice = lines_whatever_it_takes(part, ground);
  if (!choice) return std::nullopt;
  return GapGroup{std::move(part), std::move(*choice)};
}

}  // namespace

GapsTakenOn enterable_gaps(const std::vector<Gap>& gaps, const RepairGround& ground, int threads) {
  GapsTakenOn out;
  std::vector<Gap> large;
  for (const Gap& gap : gaps) {
    if (gap.area_m2 >= ground.min_area_m2)
      large.push_back(gap);
    else
      out.ignored.push_back({gap.number, gap.area_m2, gap.centre,
                             fmt::format("smaller than the least area of {:g} m²", ground.min_area_m2)});
  }
  std::vector<std::optional<GapGroup>> found(large.size());
  for_each_index(large.size(), threads, [&](std::size_t i) { found[i] = with_lines(large[i], ground); });
  for (std::size_t i = 0; i < large.size(); ++i) {
    if (found[i]) {
      out.taken.push_back(large[i]);
      out.groups.push_back(std::move(*found[i]));
    } else {
      out.unreachable.push_back(
          {large[i].number, large[i].area_m2, large[i].centre, why_unreachable(ground)});
    }
  }
  return out;
}

}  // namespace tramline
