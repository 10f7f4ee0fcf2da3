#pragma once

#include "tramline/check/verdict.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// Judges a plan from its tracks: rebuilds the swaths, recomputes every area from cells between edges (the
/// planner adds up closed forms: this is another road) and looks whether each piece obeys the
/// definitions of the glossary. So it does with headlands: their ground is made again from the boundaries,
/// and the passes are held against it. Areas may differ by 1e-6 of the field's area, and by what chords take
/// from arcs (1e-5 m along detours and passes, 1e-4 m along curved tracks, 1e-3 m along round edges of
/// headlands); lengths by 1 mm, radii by 1 %, headings where segments meet by 1°.
///
/// Violations come in the order of the rules, then of the pieces. Throws Error(kFailure) only where
/// GEOS fails. O(p·v + p log p) for p pieces and v vertices, while detours and curves
/// have few segments.
Verdict verify(const Plan& plan);

}  // namespace tramline::check
