#pragma once
// The layers of the picture of an evaluation, in the order they are drawn.

#include <vector>

#include "tramline/model/coverage.h"
#include "tramline/render/page/map_symbols.h"

namespace tramline::render {

/// The field with its holes, and the covered land, paler outside the field. Without a field all covered land
/// is drawn as inside.
void draw_covered(Canvas& canvas, const Coverage& coverage);
/// Repeated land at its true width: slivers tint the page in proportion to their area.
void draw_repeated(Canvas& canvas, const Coverage& coverage);
/// Missed land likewise, but gaps are drawn just wide enough to be visible: a page full of thin gaps must not
/// look as if most of the land had been missed.
void draw_missed(Canvas& canvas, const Coverage& coverage);
/// Land that may have been worked and was not recorded, hatched.
void draw_not_recorded(Canvas& canvas, const Coverage& coverage);
/// The path of the machine: solid where it worked, dashed where it did not.
void draw_driven(Canvas& canvas, const Coverage& coverage);
void draw_field_outline(Canvas& canvas, const Coverage& coverage);

}  // namespace tramline::render
