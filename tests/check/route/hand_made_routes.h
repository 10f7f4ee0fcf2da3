#pragma once
// Routes made by hand, leg by leg, and what the verifier finds in them.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "check/plans.h"

namespace tramline::testing_plans {

Heading towards(double degrees);

/// A leg driven from a pose; times are set by timed().
RouteLeg leg(LegKind kind, Gear gear, SteeredPath path);
/// The seconds that each leg takes, by the definition.
Plan timed(Plan plan);
/// A path of lines and arcs as it is driven forward.
SteeredPath driven(const Path& path);

// All of these go on at the end of the route.
void add(Plan& plan, RouteLeg of);
void add_piece_leg(Plan& plan, std::size_t piece);
void add_pass_leg(Plan& plan, std::size_t pass, const Path& way);
/// Arcs and lines from the end of the route, as length and curvature.
void add_way(Plan& plan, LegKind kind, const std::vector<std::pair<double, double>>& parts,
             Gear gear = Gear::kForward);
/// To a pose by the shortest way, which says that it lacks any room.
void add_shortest(Plan& plan, const Pose& to);

/// Four tracks of 12 m on 200 m x 48 m with a soft edge, r = 6 m: half circles between them. Out of the last
/// one the machine backs by 12 m and goes on by 6 m to its gate: 18 m over a track that is worked.
Plan route_plan();
/// 100 m x 60 m with two passes round it (headland_plan): the outer one closed, and driven from its third
/// segment on, against its sense; the inner one open, because its last segment is not worked.
Plan passes_plan();

double time_of(const Plan& plan);
/// All violations, a line each.
std::string texts(const Plan& plan);
void expect_found(const Plan& plan, const std::string& rule);
/// No other rule is broken.
void expect_only(const Plan& plan, const std::string& rule);

}  // namespace tramline::testing_plans
