#include "tramline/coverage/drive/time_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace tramline::coverage {

std::size_t out_of_order(const WorkLog& log) {
  std::map<int, double> latest;
  std::size_t count = 0;
  for (const Fix& fix : log.fixes) {
    if (std::isnan(fix.time_s)) continue;
    const auto [last, first] = latest.try_emplace(fix.unit, fix.time_s);
    if (!first && fix.time_s < last->second) ++count;
    last->second = fix.time_s;
  }
  return count;
}

WorkLog in_time_order(WorkLog log) {
  std::vector<double> time_s;
  time_s.reserve(log.fixes.size());
  double last_s = -std::numeric_limits<double>::infinity();
  for (const Fix& fix : log.fixes) {
    if (!std::isnan(fix.time_s)) last_s = fix.time_s;
    time_s.push_back(last_s);
  }
  std::vector<std::size_t> order(log.fixes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return time_s[a] < time_s[b]; });
  std::vector<Fix> sorted;
  sorted.reserve(order.size());
  for (const std::size_t i : order) sorted.push_back(log.fixes[i]);
  log.fixes = std::move(sorted);
  return log;
}

}  // namespace tramline::coverage
