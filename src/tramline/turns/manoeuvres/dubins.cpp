#include "tramline/turns/manoeuvres/dubins.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "tramline/turns/manoeuvres/driven_word.h"
#include "tramline/turns/manoeuvres/dubins_solutions.h"
#include "tramline/turns/manoeuvres/turn_kind.h"

namespace tramline {
namespace {

/// Calls visit(numbers) for the words that exist, in the order LSL, RSR, LSR, RSL, LRL, RLR.
template <class Visit>
void for_each_dubins(const RelativePose& to, const TurnCurve& curve, Visit visit) {
  const std::array<RelativePose, 2> sides = {to, to.mirrored()};
  for (const bool right : {false, true})
    if (const auto word = left_line_left(sides[right], curve))
      visit({"LSL", right, {word->first, word->line_m, word->last}, kind_of_one_sided(*word, to)});
  for (const bool right : {false, true})
    if (const auto word = left_line_right(sides[right], curve))
      visit({"LSR", right, {word->first, word->line_m, word->last}, ManoeuvreKind::kDubins});
  for (const bool right : {false, true})
    if (const auto word = left_right_left(sides[right], curve))
      visit({"LRL", right, {word->first, word->middle, word->last}, kind_of_three_turns(*word, to)});
}

double arcs_length(const DubinsNumbers& numbers, double radius_m) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    sum += numbers.letters[i] == 'S' ? numbers.amounts[i] : radius_m * numbers.amounts[i];
  return sum;
}

Word word_of(const DubinsNumbers& numbers, const TurnCurve& curve) {
  Word word;
  for (std::size_t i = 0; i < 3; ++i) {
    const char letter = numbers.letters[i];
    // beside a line a turn by 0 is in it already
    if (letter != 'S' && numbers.amounts[i] == 0 && numbers.letters[1] != 'S')
      word.push_back({'S', 2 * curve.ahead_m});
    else if (letter == 'S' || !numbers.mirrored)
      word.push_back({letter, numbers.amounts[i]});
    else
      word.push_back({letter == 'L' ? 'R' : 'L', numbers.amounts[i]});
  }
  return word;
}

}  // namespace

std::vector<Manoeuvre> dubins_words(const Pose& from, const Pose& to, const TurnCurve& curve) {
  std::vector<Manoeuvre> out;
  for_each_dubins(relative(from, to), curve, [&](const DubinsNumbers& numbers) {
    if (auto manoeuvre = driven(from, word_of(numbers, curve), {curve, curve}, numbers.kind))
      out.push_back(std::move(*manoeuvre));
  });
  sort_by_length(out);
  drop_repeated(out);
  return out;
}

std::vector<Manoeuvre> dubins_words(const Pose& from, const Pose& to, double radius_m) {
  assert(radius_m > 0);
  return dubins_words(from, to, arc_turn(radius_m));
}

double dubins_length(const Pose& from, const Pose& to, double radius_m) {
  assert(radius_m > 0);
  double least = std::numeric_limits<double>::infinity();
  for_each_dubins(relative(from, to), arc_turn(radius_m), [&](const DubinsNumbers& numbers) {
    least = std::min(least, arcs_length(numbers, radius_m));
  });
  return least;
}

Manoeuvre shortest_dubins(const Pose& from, const Pose& to, double radius_m) {
  assert(radius_m > 0);
  const TurnCurve curve = arc_turn(radius_m);
  double least_m = std::numeric_limits<double>::infinity();
  DubinsNumbers shortest;
  for_each_dubins(relative(from, to), curve, [&](const DubinsNumbers& numbers) {
    const double length_m = arcs_length(numbers, radius_m);
    if (length_m >= least_m - kEqualAmount) return;
    least_m = length_m;
    shortest = numbers;
  });
  return *driven(from, word_of(shortest, curve), {curve, curve}, shortest.kind);
}

DubinsWords::DubinsWords(const Pose& from, const Pose& to, double radius_m)
    : from_(from), radius_m_(radius_m) {
  assert(radius_m > 0);
  std::array<long long, 6> lengths{};  // insertion keeps the order of words that are as long
  for_each_dubins(relative(from, to), arc_turn(radius_m), [&](const DubinsNumbers& numbers) {
    const long long length = std::llround(arcs_length(numbers, radius_m) / kEqualAmount);
    std::size_t at = count_++;
    for (; at > 0 && lengths[at - 1] > length; --at) {
      lengths[at] = lengths[at - 1];
      words_[at] = words_[at - 1];
    }
    lengths[at] = length;
    words_[at] = numbers;
  });
}

DubinsWords::Ends DubinsWords::ends(std::size_t i) const {
  assert(i < count_);
  const DubinsNumbers& word = words_[i];
  const auto turned_m = [&](std::size_t part) {
    const bool left = (word.letters[part] == 'L') != word.mirrored;
    return (left ? 1 : -1) * radius_m_ * word.amounts[part];
  };
  return {turned_m(0), turned_m(2)};
}

Manoeuvre DubinsWords::built(std::size_t i) const {
  assert(i < count_);
  const TurnCurve curve = arc_turn(radius_m_);
  return *driven(from_, word_of(words_[i], curve), {curve, curve}, words_[i].kind);
}

}  // namespace tramline
