#pragma once
// Detects JSON that is too large to be kept whole.

#include <cstddef>
#include <functional>
#include <iosfwd>

namespace tramline::io {

/// Whether one of the values, of which a text may hold several one after another, is larger than `most` bytes
/// and not a FeatureCollection. `read` returns how much of the text has been read, `size` is its length in
/// bytes; the text after a fault counts towards the value with the fault. O(n), and a few bytes of memory for
/// each level of nesting.
bool has_large_json_value(std::istream& text, const std::function<std::size_t()>& read, std::size_t size,
                          std::size_t most);

}  // namespace tramline::io
