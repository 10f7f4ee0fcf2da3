#pragma once
// What a close-up shows of a plan.

#include "tramline/model/plan.h"
#include "tramline/render/page/page_layout.h"

namespace tramline::render {

/// Does the detour go round this obstacle, an index into Field::obstacles?
bool avoids(const Detour& detour, std::size_t obstacle);

/// The box round a path, to within a centimetre; m.
Box box_of(const Path& path);

/// Three working widths round the obstacle and the whole of every detour round it, as far as the plan
/// draws anything there; m.
Box close_up_window(const Plan& plan, std::size_t obstacle);

/// The land the page's map shows, m: the window and what the shape of the page adds.
Box shown_box(const PageLayout& page);

/// The plan with those pieces and faults only that may be seen in the box; indices into subfields and
/// obstacles keep their meaning. Without body, encounters and warnings.
Plan part_in(const Plan& plan, const Box& box);

}  // namespace tramline::render
