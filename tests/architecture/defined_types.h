#pragma once
// Which types a header defines.

#include <string>
#include <vector>

namespace tramline::architecture {

/// Qualified names of the structs, classes, unions and enumerations that C++ source defines in namespaces, in
/// their order: not those inside of types or functions, and not those that it declares only. O(length).
std::vector<std::string> defined_types(const std::string& source);

}  // namespace tramline::architecture
