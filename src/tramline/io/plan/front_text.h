#pragma once
// The texts of a plan file about a front.

#include <cstddef>
#include <string>
#include <vector>

#include "tramline/model/front.h"

namespace tramline::io {

/// The driving directions as a JSON list of degrees, and of radians, which restores them bit-identically.
std::string degrees_text(const std::vector<Direction>& directions);
std::string radians_text(const std::vector<Direction>& directions);
/// The inverse of radians_text(). Throws Error(kBadInput) that begins with `place` where the text is of
/// another form.
std::vector<Direction> directions_from_text(const std::string& radians, const std::string& place);

/// "knee, given prices"; empty for most points.
std::string marks_text(const Front& front, std::size_t point);
/// Sets the marks that the text names to this point. Throws Error(kBadInput) that begins with `place` where
/// there is no such mark.
void apply_marks(const std::string& text, std::size_t point, const std::string& place, FrontMarks& marks);

}  // namespace tramline::io
