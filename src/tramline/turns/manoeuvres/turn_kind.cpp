#include "tramline/turns/manoeuvres/turn_kind.h"

#include <cmath>
#include <numbers>

namespace tramline {

ManoeuvreKind kind_of_one_sided(const TurnLineTurn& word, const RelativePose& to) {
  const bool turns = word.first > 0 && word.last > 0 && word.first + word.last < kWholeCircle;
  if (!turns || to.cosine >= 0) return ManoeuvreKind::kDubins;
  return std::abs(word.first - word.last) <= kEqualArcs_rad ? ManoeuvreKind::kU : ManoeuvreKind::kUnequalArcs;
}

ManoeuvreKind kind_of_three_turns(const ThreeTurns& word, const RelativePose& to) {
  const bool turns = word.first < std::numbers::pi && word.last < std::numbers::pi &&
                     word.first + word.last > 0 && word.middle > std::numbers::pi;
  if (!turns || to.cosine >= 0) return ManoeuvreKind::kDubins;
  return std::abs(word.first - word.last) <= kEqualArcs_rad ? ManoeuvreKind::kOmega
                                                            : ManoeuvreKind::kUnequalArcs;
}

}  // namespace tramline
