#pragma once
// How long orders of lines are looked for.

namespace tramline {

/// For a plan that is compared with dozens of others, or for one that is about to be driven.
enum class Patience { kUsual, kLong };

}  // namespace tramline
