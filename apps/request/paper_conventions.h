#pragma once
// The conventions of a paper as options: what --like stands for.

#include <string>
#include <vector>

#include "request/plan_request.h"

namespace tramline::app {

/// An option as a paper would have it.
struct Convention {
  const char* option;            ///< "--end-rule"
  const char* value;             ///< as it would be typed, for --help and the pages
  void (*take)(PlanOptions& o);  ///< sets it
};

/// The conventions of `versleijen` (Versleijen 2019) or `zhou` (Zhou et al. 2020), in the order in which they
/// are to be taken. Empty for no word; throws kBadInput for any other.
std::vector<Convention> conventions_like(const std::string& paper);

/// "--strategy sweep --end-rule centre …"
std::string conventions_text(const std::string& paper);

}  // namespace tramline::app
