#pragma once
// The table under a close-up: what was decided where tracks meet the obstacle.

#include <vector>

#include "tramline/render/canvas.h"
#include "tramline/render/close_up_content.h"

namespace tramline::render {

/// px at text scale 1.
double height_of_table(const std::vector<EncounterRow>& rows);

/// `box` in pixels of the page.
void draw_encounter_table(Canvas& canvas, const Box& box, const std::vector<EncounterRow>& rows);

}  // namespace tramline::render
