#pragma once

#include "tramline/check/verify.h"

namespace tramline::check {

/// The rounding error to allow for when a sum of this value is compared.
double rounding_of(double value);

/// Compares stored figures of a tally with recomputed ones. Rule "tally".
class Comparison {
 public:
  /// `of_what` names the source of the recomputed figures: "the tracks".
  Comparison(const char* of_what, Point at, Violations& out) : of_what_(of_what), at_(at), out_(out) {}
  void number(const char* what, const char* unit, double stored, double found, double tolerance);
  void count(const char* what, int stored, int found);

 private:
  const char* of_what_;
  Point at_;
  Violations& out_;
};

}  // namespace tramline::check
