#include "tramline/route/certificate/node_join.h"

#include <algorithm>
#include <cassert>

namespace tramline::order {

JoinTree least_tree(std::vector<NodeJoin> joins, const std::vector<double>& prices_s,
                    const ConnectionBounds& bounds) {
  std::stable_sort(joins.begin(), joins.end(), [&](const NodeJoin& x, const NodeJoin& y) {
    return priced(x, prices_s) < priced(y, prices_s);
  });
  JoinedSets sets(members(bounds));
  JoinTree out;
  for (const NodeJoin& join : joins) {
    if (!sets.join(member_of(join.a, bounds.lines()), member_of(join.b, bounds.lines()))) continue;
    out.joins.push_back(join);
    out.sum_s += priced(join, prices_s);
  }
  assert(out.joins.size() + 1 == members(bounds));
  return out;
}

}  // namespace tramline::order
