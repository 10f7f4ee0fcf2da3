#pragma once
// A drive like Zhang's irregular route, made for measuring.

#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::bench {

inline constexpr int kIrregularPoints = 645;

/// 645 points with headings, 4 m wide, beginning at 180°: rows that waver, some with ground left between
/// them, turns too tight for the width, and a way back across the rows, which closes off three holes (Zhang
/// §3.2). One step between any two points.
std::vector<coverage::WorkedStep> irregular_route();

/// The field it was driven on.
Region irregular_field();

}  // namespace tramline::bench
