#include "tramline/turns/manoeuvres/driven_word.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/turns/tolerances.h"

namespace tramline {
namespace {

Word joined_parts(const Word& word, const TurnCurves& curves) {
  Word out;
  for (const WordPart& part : word) {
    assert(part.amount >= 0);
    const TurnCurve& curve = part.gear == Gear::kForward ? curves.forward : curves.reverse;
    const bool line = part.letter == 'S';
    if (part.amount <= (line ? kNoLine * curve.radius_m : kNoTurnLeast_rad)) continue;
    if (!out.empty() && out.back().letter == part.letter && out.back().gear == part.gear &&
        (line || curve.at_once()))
      out.back().amount += part.amount;
    else
      out.push_back(part);
  }
  return out;
}

std::optional<SteeredPath> driven_part(const Pose& from, const WordPart& part, const TurnCurves& curves) {
  if (part.letter == 'S') return SteeredPath{arc_from(from, part.amount, 0, part.gear)};
  return turn_from(from, part.amount, part.letter == 'L' ? TurnSide::kLeft : TurnSide::kRight, part.gear,
                   part.gear == Gear::kForward ? curves.forward : curves.reverse);
}

char shown_letter(const WordPart& part) {
  return part.gear == Gear::kForward ? part.letter : static_cast<char>(part.letter - 'A' + 'a');
}

bool same_stretches(const Manoeuvre& a, const Manoeuvre& b) {
  return a.word == b.word && std::equal(a.path.begin(), a.path.end(), b.path.begin(), b.path.end(),
                                        [](const SteeredStretch& one, const SteeredStretch& other) {
                                          return std::abs(one.length_m - other.length_m) <= kSameStretch_m;
                                        });
}

}  // namespace

std::optional<Manoeuvre> driven(const Pose& from, const Word& word, const TurnCurves& curves,
                                ManoeuvreKind kind) {
  Manoeuvre out{kind, "", {}};
  Pose at = from;
  for (const WordPart& part : joined_parts(word, curves)) {
    const std::optional<SteeredPath> stretches = driven_part(at, part, curves);
    if (!stretches) return {};
    out.word += shown_letter(part);
    out.path.insert(out.path.end(), stretches->begin(), stretches->end());
    at = end_of(out.path.back());
  }
  return out;
}

void sort_by_length(std::vector<Manoeuvre>& manoeuvres) {
  const auto amount = [](const Manoeuvre& m) { return std::llround(length(m.path) / kEqualAmount); };
  std::stable_sort(manoeuvres.begin(), manoeuvres.end(),
                   [&](const Manoeuvre& a, const Manoeuvre& b) { return amount(a) < amount(b); });
}

void drop_repeated(std::vector<Manoeuvre>& manoeuvres) {
  std::vector<Manoeuvre> kept;
  for (Manoeuvre& manoeuvre : manoeuvres)
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const Manoeuvre& before) { return same_stretches(before, manoeuvre); }))
      kept.push_back(std::move(manoeuvre));
  manoeuvres = std::move(kept);
}

}  // namespace tramline
