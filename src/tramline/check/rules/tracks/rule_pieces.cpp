#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tramline/check/measure/sound_path.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// The fault of the position of a curve between the ends of its piece, or "". Precondition: a path.
std::string fault_of_curve(const TrackPiece& piece) {
  if (const std::string fault = check::fault_of(piece.curve); !fault.empty()) return "'s curve: " + fault;
  if (distance(piece.curve.front().from, piece.start) > kJoint_m ||
      distance(piece.curve.back().to, piece.end) > kJoint_m)
    return " is not as long as its curve";
  return "";
}

/// The rest of a piece that no detour has used yet. Detours of a straight piece begin and end on its line;
/// those of a curved piece are parts of its curve.
class FreeLine {
 public:
  explicit FreeLine(const TrackPiece& piece)
      : piece_(piece), frame_(piece), free_from_(piece.curve.begin()) {}

  /// The fault of the position of the next detour on it, or "". Precondition: a sound path.
  std::string take(const Path& detour) {
    return piece_.curve.empty() ? take_from_line(detour) : take_from_curve(detour);
  }

 private:
  std::string take_from_line(const Path& detour) {
    const Point begin = frame_.to_local(detour.front().from), end = frame_.to_local(detour.back().to);
    if (std::abs(begin.x) > kLengthTolerance_m || std::abs(end.x) > kLengthTolerance_m)
      return "does not begin and end on the line of its piece";
    if (begin.y < free_from_m_ - kJoint_m) return "begins before its piece or the detour before";
    if (end.y <= begin.y || end.y > frame_.length() + kJoint_m) return "does not end ahead on its piece";
    free_from_m_ = end.y;
    return "";
  }
  std::string take_from_curve(const Path& detour) {
    const auto found = std::search(free_from_, piece_.curve.end(), detour.begin(), detour.end());
    if (found == piece_.curve.end()) return "is no part of the curve of its piece";
    free_from_ = found + static_cast<std::ptrdiff_t>(detour.size());
    return "";
  }

  const TrackPiece& piece_;
  PieceFrame frame_;
  double free_from_m_ = 0;
  Path::const_iterator free_from_;
};

/// Precondition: the piece is sound except for its detours.
void check_detours_of(const Plan& plan, std::size_t index, Violations& out) {
  const TrackPiece& piece = plan.pieces[index];
  FreeLine free(piece);
  for (std::size_t k = 0; k < piece.detours.size(); ++k) {
    const Detour& detour = piece.detours[k];
    std::string fault = check::fault_of(detour.path);
    if (fault.empty()) fault = free.take(detour.path);
    if (fault.empty() && detour.side == Passing::kCut) fault = "passes its obstacles on no side";
    if (fault.empty() && !exist(plan, detour.obstacles)) fault = "names an obstacle that does not exist";
    if (!fault.empty()) {
      out.push_back({Rule::kPieces, detour_name(index, k) + " " + fault, piece.start, 0});
      return;
    }
  }
}

void check_piece(const Plan& plan, std::size_t index, Violations& out) {
  const TrackPiece& piece = plan.pieces[index];
  const std::string name = piece_name(index);
  if (!on_the_map(piece.start) || !on_the_map(piece.end)) {
    out.push_back({Rule::kPieces, name + " has an end off the map", {}, 0});
    return;
  }
  if (distance(piece.start, piece.end) <= kShortest_m) {
    out.push_back({Rule::kPieces, name + " has no length", piece.start, 0});
    return;
  }
  if (piece.subfield >= plan.subfields.size()) {
    // Numbers below 1 in a file have become indices beyond all others.
    const auto number = static_cast<long long>(piece.subfield) + 1;
    out.push_back(
        {Rule::kPieces,
         fmt::format("{} belongs to subfield {}, and there are {}", name, number, plan.subfields.size()),
         piece.start, static_cast<double>(number)});
    return;
  }
  const Subfield& subfield = plan.subfields[piece.subfield];
  if (!piece.curve.empty()) {
    if (const std::string fault = fault_of_curve(piece); !fault.empty())
      out.push_back({Rule::kPieces, name + fault, piece.start, 0});
    else
      check_detours_of(plan, index, out);
    if (subfield.reference.empty() && !is_repair(plan) && !is_of_lines(plan))
      out.push_back(
          {Rule::kPieces, name + " follows a curve, and its subfield has no reference line", piece.start, 0});
    return;
  }
  check_detours_of(plan, index, out);
  if (follows_curve(plan, piece.subfield) || is_of_lines(plan)) return;
  const Direction direction = subfield.direction;
  const double off_m = std::abs(cross(piece.end - piece.start, direction.unit()));
  // Written so that an undefined direction (NaN) is a violation too.
  if (!(off_m <= kLengthTolerance_m))
    out.push_back({Rule::kPieces,
                   fmt::format("{} ends {:.3f} m off the direction of its subfield", name, off_m), piece.end,
                   off_m});
}

void check_size(double metres, double least_m, const char* what, Violations& out) {
  // Written so that NaN is a violation.
  if (metres >= least_m && metres <= kFarthest_m) return;
  out.push_back({Rule::kPieces, fmt::format("{} is {} m", what, metres), {}, metres});
}

}  // namespace

void check_pieces(const Plan& plan, Violations& out) {
  check_size(plan.machine.width_m, std::numeric_limits<double>::min(), "the working width", out);
  check_size(plan.machine.radius_m, 0, "the turning radius", out);
  check_size(plan.settings.clearance_m, 0, "the clearance", out);
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) check_piece(plan, i, out);
}

}  // namespace tramline::check
