#include "tramline/turns/manoeuvres/turn_kind.h"

#include <cmath>
#include <numbers>

namespace tramline {

ManoeuvreKind kind_of_one_sided(const TurnLineTurn& word, const RelativePose& to) {
  if (to.cosine >= 0 || word.first + word.last >= kWholeCircle) return ManoeuvreKind::kDubins;
  const bool both = word.first > 0 && word.last > 0;
  const bool one = !both && word.first + word.last > 0 && word.line_m == 0;
  if (one) return ManoeuvreKind::kU;
  if (!both) return ManoeuvreKind::kDubins;
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
