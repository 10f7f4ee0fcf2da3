#include "tramline/model/track.h"

namespace tramline {

Ring swath(const TrackPiece& piece, double width_m) {
  const Point along = piece.end - piece.start;
  const double half = 0.5 * width_m / length(along);
  const Point right{half * along.y, -half * along.x};
  return {piece.start + right, piece.end + right, piece.end - right, piece.start - right};
}

}  // namespace tramline
