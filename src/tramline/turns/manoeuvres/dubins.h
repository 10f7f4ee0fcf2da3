#pragma once
// The shortest ways forward from one pose to another.

#include <array>
#include <cstddef>
#include <vector>

#include "tramline/model/manoeuvre.h"
#include "tramline/turns/manoeuvres/relative_pose.h"
#include "tramline/turns/manoeuvres/turn_curve.h"

namespace tramline {

/// The words LSL, RSR, LSR, RSL, LRL and RLR of Dubins (1957) between two poses, as far as they exist, the
/// shortest first (of equal ones in this order): the formulas of Shkel and Lumelsky (2001) from the centres
/// of the turns. The shortest of them is the shortest way forward of least radius `radius_m`. Parts without
/// length are left out, so a word may have one letter, or none between equal poses; what then repeats another
/// word is left out. The kind is kU, kOmega or kUnequalArcs where turn_kind.h says so, otherwise kDubins.
/// Metres, frame of the poses. Ends in `to` within 1e-9 of the distance and radius. Precondition: radius_m >
/// 0.
std::vector<Manoeuvre> dubins_words(const Pose& from, const Pose& to, double radius_m);
/// The same with clothoids at both ends of every turn (Fraichard and Scheuer 2004); a word exists where there
/// is room for them, so between near poses there may be fewer and longer ways, and in rare cases none. As the
/// steering time goes to 0 the words become those above.
std::vector<Manoeuvre> dubins_words(const Pose& from, const Pose& to, const TurnCurve& curve);

/// The length of the shortest of them, m, without building any. 0 between equal poses. O(1), allocates
/// nothing. Precondition: radius_m > 0.
double dubins_length(const Pose& from, const Pose& to, double radius_m);
/// The same for a pose as it is seen from the other one.
double dubins_length(const RelativePose& target, double radius_m);
/// The shortest of dubins_words(), without building the others. Precondition: radius_m > 0.
Manoeuvre shortest_dubins(const Pose& from, const Pose& to, double radius_m);

/// A word by its numbers: letters as if it began to the left, an amount for each (rad of a turn, m of a
/// line), and whether L stands for a turn to the right.
struct DubinsNumbers {
  const char* letters = "";
  bool mirrored = false;
  std::array<double, 3> amounts{};
  ManoeuvreKind kind = ManoeuvreKind::kDubins;
};

/// What dubins_words() returns, without building it; a word that repeats another may be among them. For those
/// who leave most words alone for how they begin and end. Allocates nothing.
class DubinsWords {
 public:
  /// Precondition: radius_m > 0.
  DubinsWords(const Pose& from, const Pose& to, double radius_m);

  std::size_t size() const { return count_; }

  /// The way on which a word turns before anything else, and the one on which it turns last, m: positive to
  /// the left, negative to the right, 0 where it begins or ends with a line. A word of one turn in two parts
  /// begins with one of them.
  struct Ends {
    double first_m = 0, last_m = 0;
  };
  /// Of the words, the shortest first. Precondition: i < size().
  Ends ends(std::size_t i) const;
  Manoeuvre built(std::size_t i) const;

 private:
  Pose from_;
  double radius_m_;
  std::array<DubinsNumbers, 6> words_{};
  std::size_t count_ = 0;
};

}  // namespace tramline
