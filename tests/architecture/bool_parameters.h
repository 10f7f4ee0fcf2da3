#pragma once
// Parameters that leave the reader of a call with `true` and `false`. A pure function over text, so that it
// is tested with made-up headers.

#include <string>
#include <vector>

namespace tramline::architecture {

/// One parameter that is a bool by value.
struct BoolParameter {
  int line = 0;
  std::string function;
  std::string parameter;  ///< empty where it has no name
};

/// Those of the functions of namespaces and of public member functions that a header declares, from top to
/// bottom. Left out are operators, whose operand is the value itself, and overriding functions, which take
/// what their base takes.
std::vector<BoolParameter> bool_parameters(const std::string& header);

}  // namespace tramline::architecture
