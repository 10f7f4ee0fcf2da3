#include "tramline/coverage/tiles/cell_state.h"

namespace tramline::coverage {
namespace {

constexpr CellState kRepeatedOrUnrecorded = 8;

CellState marked(CellState state) { return static_cast<CellState>(state | kRepeatedOrUnrecorded); }

/// The same ground, worked so often and not marked as repeated.
CellState worked(CellState state, int times) {
  return static_cast<CellState>((state & kUnworkedField) | times << 1);
}

bool is(LandClass what, CellState state) {
  const int times = times_worked(state);
  switch (what) {
    case LandClass::kCovered:
      return times > 0;
    case LandClass::kRepeated:
      return is_repeated(state);
    case LandClass::kSliver:
      return times > 1 && !is_repeated(state);
    case LandClass::kMissed:
      return times == 0 && in_field(state) && !is_unrecorded(state);
    case LandClass::kUnrecorded:
      return is_unrecorded(state);
    case LandClass::kOutside:
      return times > 0 && !in_field(state);
    case LandClass::kOnce:
      return times == 1;
    case LandClass::kTwice:
      return times == 2;
    case LandClass::kOften:
      return times == kMostCounted;
    case LandClass::kAgain:
      return times > 1;
  }
  return false;
}

}  // namespace

Transition worked_again(int most) {
  Transition out{};
  for (CellState s = 0; s < kCellStates; ++s) {
    const CellState once_more = worked(s, std::max(times_worked(s), std::min(times_worked(s) + 1, most)));
    out[s] = is_repeated(s) ? marked(once_more) : once_more;
  }
  return out;
}

Transition made_repeated() {
  Transition out{};
  for (CellState s = 0; s < kCellStates; ++s) out[s] = times_worked(s) > 0 ? marked(s) : s;
  return out;
}

Transition made_unrecorded() {
  Transition out{};
  for (CellState s = 0; s < kCellStates; ++s) out[s] = times_worked(s) == 0 ? marked(s) : s;
  return out;
}

Transition made_unrecorded_in_field() {
  Transition out = made_unrecorded();
  for (CellState s = 0; s < kCellStates; ++s)
    if (!in_field(s)) out[s] = s;
  return out;
}

StateSet states_of(LandClass what) {
  unsigned out = 0;
  for (CellState s = 0; s < kCellStates; ++s) out |= (is(what, s) ? 1U : 0U) << s;
  return static_cast<StateSet>(out);
}

StateSet changed_by(const Transition& next) {
  unsigned out = 0;
  for (CellState s = 0; s < kCellStates; ++s) out |= (next[s] != s ? 1U : 0U) << s;
  return static_cast<StateSet>(out);
}

}  // namespace tramline::coverage
