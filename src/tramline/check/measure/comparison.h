#pragma once

#include "tramline/check/verify.h"

namespace tramline::check {

/// Sums are rounded like any other: a comparison of sums allows for it.
double rounding_of(double value);

/// Stored figures of a tally against found ones. Rule "tally".
class Comparison {
 public:
  /// `of_what` amounts to the figures found: "the tracks".
  Comparison(const char* of_what, Point at, Violations& out) : of_what_(of_what), at_(at), out_(out) {}
  void number(const char* what, const char* unit, double stored, double found, double tolerance);
  void count(const char* what, int stored, int found);

 private:
  const char* of_what_;
  Point at_;
  Violations& out_;
};

}  // namespace tramline::check
