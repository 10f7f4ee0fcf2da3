#include <fmt/format.h>

#include <cmath>

#include "tramline/check/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

constexpr const char* kRule = "pieces";

/// Written so that NaN is not.
bool on_the_map(Point p) { return std::abs(p.x) <= kFarthest_m && std::abs(p.y) <= kFarthest_m; }

void check_piece(const Plan& plan, std::size_t index, Violations& out) {
  const TrackPiece& piece = plan.pieces[index];
  const std::string name = piece_name(index);
  if (!on_the_map(piece.start) || !on_the_map(piece.end)) {
    out.push_back({kRule, name + " has an end off the map", {}, 0});
    return;
  }
  if (piece.start == piece.end) {
    out.push_back({kRule, name + " has no length", piece.start, 0});
    return;
  }
  if (piece.subfield < 0 || static_cast<std::size_t>(piece.subfield) >= plan.subfields.size()) {
    out.push_back({kRule,
                   fmt::format("{} belongs to subfield {}, and there are {}", name, piece.subfield + 1,
                               plan.subfields.size()),
                   piece.start, static_cast<double>(piece.subfield + 1)});
    return;
  }
  const Direction direction = plan.subfields[static_cast<std::size_t>(piece.subfield)].direction;
  const double off_m = std::abs(cross(piece.end - piece.start, direction.unit()));
  // Written so that an undefined direction (NaN) is a violation too.
  if (!(off_m <= kLengthTolerance_m))
    out.push_back({kRule, fmt::format("{} ends {:.3f} m off the direction of its subfield", name, off_m),
                   piece.end, off_m});
}

}  // namespace

void check_pieces(const Plan& plan, Violations& out) {
  if (!(plan.machine.width_m > 0) || plan.machine.width_m > kFarthest_m)
    out.push_back(
        {kRule, fmt::format("the working width is {} m", plan.machine.width_m), {}, plan.machine.width_m});
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) check_piece(plan, i, out);
}

}  // namespace tramline::check
