#include "tramline/turns/manoeuvres/manoeuvre_choice.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <tuple>

#include "tramline/turns/manoeuvres/driven_word.h"
#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/manoeuvres/fishtail.h"
#include "tramline/turns/manoeuvres/reeds_shepp.h"
#include "tramline/turns/manoeuvres/three_turns.h"
#include "tramline/turns/manoeuvres/u_turn.h"
#include "tramline/turns/manoeuvres/unequal_arcs.h"
#include "tramline/turns/outline/outline.h"
#include "tramline/turns/tolerances.h"

namespace tramline {
namespace {

void add_manoeuvres(std::vector<Manoeuvre>& out, std::vector<Manoeuvre> more) {
  std::move(more.begin(), more.end(), std::back_inserter(out));
}

void add_manoeuvres(std::vector<Manoeuvre>& out, std::optional<Manoeuvre> one) {
  if (one) out.push_back(std::move(*one));
}

/// The words of Dubins driven in reverse: those from the end to the start, retraced.
std::vector<Manoeuvre> words_in_reverse(const Pose& from, const Pose& to, const TurnCurve& curve) {
  std::vector<Manoeuvre> out = dubins_words(to, from, curve);
  for (Manoeuvre& word : out) {
    word.kind = ManoeuvreKind::kReedsShepp;
    word.path = retraced(word.path);
    std::reverse(word.word.begin(), word.word.end());
    for (char& letter : word.word) letter = static_cast<char>(letter - 'A' + 'a');
  }
  return out;
}

std::vector<Manoeuvre> reversing(const Pose& from, const Pose& to, const TurnCurves& curves) {
  std::vector<Manoeuvre> out = fishtails(from, to, curves);
  add_manoeuvres(out, words_in_reverse(from, to, curves.reverse));
  add_manoeuvres(out, curves.forward.at_once() ? reeds_shepp_words(from, to, curves.forward.radius_m)
                                               : three_turns(from, to, curves));
  return out;
}

void sort_by_time(std::vector<Manoeuvre>& manoeuvres, const Machine& machine) {
  const auto key = [&](const Manoeuvre& m) {
    return std::tuple(std::llround(seconds(m, machine) / kEqualAmount), gear_changes(m), m.kind, m.word);
  };
  std::stable_sort(manoeuvres.begin(), manoeuvres.end(),
                   [&](const Manoeuvre& a, const Manoeuvre& b) { return key(a) < key(b); });
}

}  // namespace

std::vector<Manoeuvre> manoeuvres_between(const Pose& from, const Pose& to, const Machine& machine) {
  assert(machine.radius_m > 0 && machine.turning.turning_speed_mps > 0 &&
         machine.turning.reverse_speed_mps > 0);
  const TurnCurves curves = turn_curves(machine);
  std::vector<Manoeuvre> out = dubins_words(from, to, curves.forward);
  add_manoeuvres(out, u_turn(from, to, curves.forward));
  add_manoeuvres(out, lead_and_turn(from, to, curves.forward));
  // A drawbar folds up in reverse.
  if (machine.turning.reverse && !outline_of(machine).tows())
    add_manoeuvres(out, reversing(from, to, curves));
  drop_repeated(out);  // the first keeps its name
  sort_by_time(out, machine);
  return out;
}

}  // namespace tramline
