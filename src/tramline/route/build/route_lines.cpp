#include "tramline/route/build/route_lines.h"

#include <cassert>

#include "tramline/route/axle/axle_path.h"

namespace tramline {
namespace {

DrivenSense sense_of(const order::WorkedLine& line, const Turning& turning) {
  return {axle_path(line.front(), turning), axle_path(line.back(), turning)};
}

}  // namespace

RouteLine route_line(const order::WorkedLine& line, const Turning& turning) {
  RouteLine out;
  out.senses = {sense_of(line, turning), sense_of(order::backwards(line), turning)};
  return out;
}

RouteLine route_line(const HeadlandPass& pass, std::size_t number, const Turning& turning) {
  assert(!is_closed(pass));
  RouteLine out;
  out.pass = number;
  const SteeredPath there = axle_path(pass.path, turning), back = axle_path(reversed(pass.path), turning);
  out.senses = {DrivenSense{there, there}, DrivenSense{back, back}};
  return out;
}

Pose pose_left_by(const RouteLine& line, order::End end) { return end_of(line.left_by(end).last); }
Pose pose_entered_by(const RouteLine& line, order::End end) {
  return line.entered_by(end).first.front().start;
}

}  // namespace tramline
