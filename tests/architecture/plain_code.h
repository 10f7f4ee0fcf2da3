#pragma once
// Sources as text that can be searched for declarations.

#include <string>

namespace tramline::architecture {

/// Without comments, literals and lines of the preprocessor: none of these opens a block. Every line keeps
/// its number.
std::string plain_code(const std::string& source);

}  // namespace tramline::architecture
