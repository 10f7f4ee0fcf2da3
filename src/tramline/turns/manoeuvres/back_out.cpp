#include "tramline/turns/manoeuvres/back_out.h"

#include <cassert>

#include "tramline/turns/manoeuvres/dubins.h"

namespace tramline {

std::optional<Manoeuvre> back_out(const Pose& from, const Pose& to, const TurnCurve& curve, double back_m) {
  assert(back_m > 0);
  const SteeredStretch back = arc_from(from, back_m, 0, Gear::kReverse);
  const std::vector<Manoeuvre> words = dubins_words(end_of(back), to, curve);
  if (words.empty()) return {};
  Manoeuvre out{ManoeuvreKind::kBackOut, "s" + words.front().word, {back}};
  out.path.insert(out.path.end(), words.front().path.begin(), words.front().path.end());
  return out;
}

std::optional<Manoeuvre> back_out(const Pose& from, const Pose& to, double radius_m, double back_m) {
  assert(radius_m > 0);
  return back_out(from, to, arc_turn(radius_m), back_m);
}

}  // namespace tramline
