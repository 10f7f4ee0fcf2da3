#pragma once
// The layers of the picture of an evaluation, in the order they are drawn.

#include <vector>

#include "tramline/model/coverage.h"
#include "tramline/render/page/map_symbols.h"

namespace tramline::render {

/// The field, what lies within it and is no part of it, and what was covered: paler outside the field.
/// Without a field all of it is drawn as inside.
void draw_covered(Canvas& canvas, const Coverage& coverage);
/// Repeated land as wide as it is: slivers tint the page by what they take of it.
void draw_repeated(Canvas& canvas, const Coverage& coverage);
/// Missed land likewise; but gaps at least so wide that none escapes the eye, and no wider: a page full of
/// thin gaps must not look as if most of the land had been missed.
void draw_missed(Canvas& canvas, const Coverage& coverage);
/// What may have been worked and was not recorded, hatched.
void draw_not_recorded(Canvas& canvas, const Coverage& coverage);
/// The way of the machine: solid where it worked, dashed where it did not.
void draw_driven(Canvas& canvas, const Coverage& coverage);
void draw_field_outline(Canvas& canvas, const Coverage& coverage);

}  // namespace tramline::render
