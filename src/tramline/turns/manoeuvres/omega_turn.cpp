#include "tramline/turns/manoeuvres/omega_turn.h"

#include <algorithm>
#include <cassert>

#include "tramline/turns/manoeuvres/dubins.h"

namespace tramline {

std::optional<Manoeuvre> omega_turn(const Pose& from, const Pose& to, const TurnCurve& curve) {
  std::vector<Manoeuvre> words = dubins_words(from, to, curve);
  const auto omega = std::find_if(words.begin(), words.end(),
                                  [](const Manoeuvre& word) { return word.kind == ManoeuvreKind::kOmega; });
  if (omega == words.end()) return {};
  return std::move(*omega);
}

std::optional<Manoeuvre> omega_turn(const Pose& from, const Pose& to, double radius_m) {
  assert(radius_m > 0);
  return omega_turn(from, to, arc_turn(radius_m));
}

}  // namespace tramline
