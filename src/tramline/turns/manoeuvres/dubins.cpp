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

/// Adds up in the order of the parts, as arcs_length() does.
double sum_of_parts(const TurnLineTurn& word, double radius_m) {
  return radius_m * word.first + word.line_m + radius_m * word.last;
}

double sum_of_parts(const ThreeTurns& word, double radius_m) {
  return radius_m * word.first + radius_m * word.middle + radius_m * word.last;
}

double arcs_length(const DubinsNumbers& numbers, double radius_m) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    sum += numbers.letters[i] == 'S' ? numbers.amounts[i] : radius_m * numbers.amounts[i];
  return sum;
}

enum class Letters { kLsl, kLsr, kLrl };

/// A word that is yet to be solved: its letters as if it began to the left, whether it begins to the right,
/// and a length that it has at the least.
struct BoundedWord {
  double least_m = 0;
  Letters letters = Letters::kLsl;
  bool right = false;

  friend bool operator<(const BoundedWord& a, const BoundedWord& b) { return a.least_m < b.least_m; }
};

/// The words on circles, without their angles. Turns to one side add up to the change of heading, turns to
/// both sides differ by it, and a middle turn is more than half a circle.
std::array<BoundedWord, 6> bounded_words(const std::array<RelativePose, 2>& sides, const TurnCurve& curve) {
  // What a turn of a whole circle that is none by rounding may take off a word.
  const double noise = 3 * kNoTurnMost_rad, r = curve.radius_m;
  std::array<BoundedWord, 6> out;
  std::size_t count = 0;
  for (const bool right : {false, true}) {
    const RelativePose& to = sides[right];
    const Point along = between_centres(to, curve, TurnSide::kLeft),
                across = between_centres(to, curve, TurnSide::kRight);
    const double turned = to.turn >= kWholeCircle - noise ? 0 : to.turn;
    out[count++] = {length(along) + r * (turned - noise), Letters::kLsl, right};
    const double line_square = dot(across, across) - 4 * r * r;
    const double differ = std::min(to.turn, kWholeCircle - to.turn);
    out[count++] = {std::sqrt(std::max(0.0, line_square)) + r * (differ - noise), Letters::kLsr, right};
    out[count++] = {r * (0.5 * kWholeCircle - noise), Letters::kLrl, right};
  }
  return out;
}

/// Infinity where there is no such word. `to`: mirrored for words to the right.
double length_of(const BoundedWord& word, const RelativePose& to, const TurnCurve& curve) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (word.letters == Letters::kLrl) {
    const auto found = left_right_left(to, curve);
    return found ? sum_of_parts(*found, curve.radius_m) : kNone;
  }
  const auto found = word.letters == Letters::kLsl ? left_line_left(to, curve) : left_line_right(to, curve);
  return found ? sum_of_parts(*found, curve.radius_m) : kNone;
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
  return dubins_length(relative(from, to), radius_m);
}

double dubins_length(const RelativePose& target, double radius_m) {
  assert(radius_m > 0);
  const std::array<RelativePose, 2> sides = {target, target.mirrored()};
  const TurnCurve curve = arc_turn(radius_m);
  std::array<BoundedWord, 6> words = bounded_words(sides, curve);
  std::sort(words.begin(), words.end());
  double least = std::numeric_limits<double>::infinity();
  for (const BoundedWord& word : words) {
    if (word.least_m >= least) break;
    least = std::min(least, length_of(word, sides[word.right], curve));
  }
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
