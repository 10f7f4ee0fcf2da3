#include "tramline/route/certificate/node_join.h"

#include <algorithm>
#include <cassert>

namespace tramline::order {

JoinTree least_tree(std::vector<NodeJoin> joins, const std::vector<double>& prices_s,
                    const ConnectionBounds& bounds) {
  std::stable_sort(joins.begin(), joins.end(), [&](const NodeJoin& x, const NodeJoin& y) {
    return priced(x, prices_s) < priced(y, prices_s);
  });
  JoinedSets sets(bounds.members());
  JoinTree out;
  for (const NodeJoin& join : joins) {
    if (!sets.join(bounds.member_of(join.a), bounds.member_of(join.b))) continue;
    out.joins.push_back(join);
    out.sum_s += priced(join, prices_s);
  }
  assert(out.joins.size() + 1 == bounds.members());
  return out;
}

}  // namespace tramline::order
