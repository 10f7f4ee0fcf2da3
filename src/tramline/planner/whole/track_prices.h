#pragma once
// What tracks cost by the rates of their machine, before a route joins them.

#include "tramline/model/machine.h"
#include "tramline/model/objective.h"

namespace tramline {

/// Prices of overlap, uncovered land, turns, stops and subfields that sum to the whole cost (WholeCost) of
/// tracks, but for what only their route shows. Since the length of tracks of width w is (body − u + o)/w,
/// time at work is a price of overlap and a gain of uncovered land: overlap costs the input of one section
/// and the work, uncovered land the margin less the work, at least a tenth of the margin. A turn costs the
/// quickest one between parallel tracks: half a circle and the straight that is left to the nearest track
/// that is not nearer than a diameter. A stop costs its price and a minute to back out and drive round, a
/// further subfield a minute on the way. O(1).
Objective track_prices(const Machine& machine);

}  // namespace tramline
