#pragma once
// What several rules about the route need.

#include <cstddef>
#include <string>
#include <vector>

#include "tramline/check/turning/axle_line.h"
#include "tramline/check/turning/land_parts.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// "leg 12 (turn)": legs are numbered for people from 1, in driving order.
std::string leg_name(const Plan& plan, std::size_t leg);

/// The legs along one headland pass, in driving order: with the work on, and off on passable obstacles.
std::vector<std::size_t> legs_of_pass(const Plan& plan, std::size_t pass);
/// The work legs, in driving order.
std::vector<std::size_t> work_legs(const Plan& plan);

/// The axle's places while the implement works along a path that begins at its start.
class WorkedCourse {
 public:
  WorkedCourse(const Path& path, PathEnds ends, const Machine& machine)
      : line_(path, ends), ahead_m_(ahead_of_work_m(machine)) {}

  double length_m() const { return line_.length_m(); }
  /// Where the axle is when the implement has worked so much of the path, m.
  LinePlace axle(double worked_m) const { return line_.place(worked_m + ahead_m_); }
  Point implement(double worked_m) const { return line_.place(worked_m).at; }
  const AxleLine& line() const { return line_; }
  double ahead_m() const { return ahead_m_; }

 private:
  AxleLine line_;
  double ahead_m_;
};

WorkedCourse course_of_piece(const Plan& plan, std::size_t piece);
/// From the beginning of the pass to its end, or the other way.
enum class PassSense { kAlong, kAgainst };
WorkedCourse course_of_pass(const Plan& plan, std::size_t pass, PassSense sense);

/// The part of the land on which the line or pass of a leg lies. Passes with sharp corners, of which no bound
/// knows, are worked in one phase: with these all is one part. Precondition: the leg leads along a piece or a
/// pass.
std::size_t part_of(const RouteLeg& leg, const Plan& plan, const LandParts& parts);
/// On how many parts there is work; legs along pieces or passes that do not exist do not count.
std::size_t parts_with_work(const Plan& plan, const LandParts& parts);

/// Whether a leg leaves the land, and not just by what corners of the machine swing out of the band that it
/// works where a headland pass turns as sharply as the machine can.
bool cannot_be_driven(const Plan& plan, const RouteLeg& leg);

/// How far the heading is from a direction, degrees.
double turned_deg(Point ahead, Point other);

}  // namespace tramline::check
