#pragma once
// The legs of a route, one after the other.

#include <cstddef>
#include <vector>

#include "tramline/model/field.h"
#include "tramline/model/headland.h"
#include "tramline/model/route.h"
#include "tramline/route/connection/way.h"
#include "tramline/route/order/lines.h"
#include "tramline/route/passes/pass_entries.h"

namespace tramline {

/// Collects legs in driving order.
class LegList {
 public:
  /// Both outlive the list.
  LegList(const Field& field, const Turning& turning) : field_(&field), turning_(&turning) {}

  void add(const Way& way);
  /// The pieces of a line in the sense in which it is driven. `first_piece`: the index of its first piece in
  /// the plan.
  void add(const order::WorkedLine& line, std::size_t first_piece);
  /// A pass, in parts with the work off where it leads across passable obstacles.
  void add(const HeadlandPass& pass, std::size_t number, const PassEntry& entry);

  /// All of them, with their times: lengths by the speeds of working, turning and reversing, and changes of
  /// gear.
  std::vector<RouteLeg> finished() &&;

 private:
  const Field* field_;
  const Turning* turning_;
  std::vector<RouteLeg> legs_;
};

/// The time of a leg behind one in this gear, s.
double leg_seconds(const RouteLeg& leg, Gear before, const Turning& turning);

}  // namespace tramline
