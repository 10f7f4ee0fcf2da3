#pragma once
// The table under a close-up: the choices made where tracks reach the obstacle.

#include <array>
#include <string>
#include <vector>

#include "tramline/render/close_up/close_up_content.h"
#include "tramline/render/page/canvas.h"
#include "tramline/render/page/text.h"

namespace tramline::render {

/// Height of the table, px at text scale 1.
double height_of_table(const std::vector<EncounterRow>& rows);

/// The four cells of a row as drawn into `box`, pixels of the page: cut where their column ends.
std::array<std::string, 4> cells_of(Canvas& canvas, const Box& box, const EncounterRow& row,
                                    const TextStyle& style);

/// Draws the table into `box`, pixels of the page.
void draw_encounter_table(Canvas& canvas, const Box& box, const std::vector<EncounterRow>& rows);

}  // namespace tramline::render
