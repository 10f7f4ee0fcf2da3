#pragma once
// The parallel loop of the planner.

#include <cstddef>
#include <functional>
#include <vector>

#include "tramline/planner/search_context.h"

namespace tramline {

/// Calls body(0) … body(count − 1), each once, in any order and on up to as many threads as the context
/// allows, and returns when all are done. If calls throw, one of the exceptions is thrown on, and calls not
/// yet begun may be left out. Reports progress before each. `body` must be safe to call concurrently.
void for_each_index(std::size_t count, const SearchContext& context,
                    const std::function<void(std::size_t)>& body);

/// Calls both in the same way.
void side_by_side(const SearchContext& context, const std::function<void()>& one,
                  const std::function<void()>& other);

/// As for_each_index(), except that a search that has to end may leave out calls other than body(0). Returns
/// which calls were made.
std::vector<bool> for_each_index_until_end(std::size_t count, const SearchContext& context,
                                           const std::function<void(std::size_t)>& body);

}  // namespace tramline
