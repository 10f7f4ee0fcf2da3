#pragma once
// The part of a plan that a close-up shows.

#include "tramline/model/plan.h"
#include "tramline/render/page/page_layout.h"

namespace tramline::render {

/// Whether the detour goes round this obstacle, an index into Field::obstacles.
bool avoids(const Detour& detour, std::size_t obstacle);

/// The box round a path, to within a centimetre; m.
Box box_of(const Path& path);

/// Three working widths round the obstacle and the whole of every detour round it, as far as the plan
/// draws anything there; m.
Box close_up_window(const Plan& plan, std::size_t obstacle);

/// The box that the page's map shows, m: the window, extended to the shape of the map.
Box shown_box(const PageLayout& page);

/// The plan with only the pieces and faults that may be visible in the box; indices into subfields and
/// obstacles keep their meaning. Without body, encounters and warnings.
Plan part_in(const Plan& plan, const Box& box);

}  // namespace tramline::render
