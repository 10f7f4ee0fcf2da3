#pragma once
// Limits the memory that XML takes once it is parsed.

#include <cstddef>
#include <string>
#include <string_view>

namespace tramline::io {

/// The largest tree of elements, texts and attributes that a parser may make of a text; larger ones are
/// refused. A GPX file of 128 MiB whose points have a height and a time takes 512 MiB.
inline constexpr std::size_t kMostXmlTree = std::size_t{640} << 20;

/// An upper bound of the bytes that the tree of this text takes, estimated from its markup characters alone.
/// O(n), without memory.
std::size_t xml_tree_bytes(std::string_view xml);

/// Throws bad_input that begins with `place`, before anything is parsed, where the tree would be larger.
void require_bounded_xml(std::string_view xml, const std::string& place, std::size_t most = kMostXmlTree);

}  // namespace tramline::io
