#pragma once
// Conversion between the input's coordinates and the plane in which a field is planned.

#include <memory>
#include <optional>

#include "tramline/geodesy/crs.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/local_frame.h"

namespace tramline {

/// Converts longitude and latitude to local metres and back, by the frame alone. Owns a PROJ context: one
/// object on one thread at a time. Over a field the projection is true to better than 1e-12 m there and back.
class FrameProjection {
 public:
  /// Precondition: frame.geodetic.
  explicit FrameProjection(const LocalFrame& frame);
  FrameProjection(const FrameProjection&) = delete;
  FrameProjection& operator=(const FrameProjection&) = delete;
  FrameProjection(FrameProjection&&) noexcept;
  FrameProjection& operator=(FrameProjection&&) noexcept;
  ~FrameProjection();

  /// Local metres of a WGS 84 longitude and latitude; nullopt where the projection is not defined.
  std::optional<Point> from_lonlat(Point lonlat_deg) const;
  /// WGS 84 longitude and latitude, degrees. Throws failure far outside the projection.
  Point to_lonlat(Point local_m) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The frame for input whose coordinates lie in `bounds` (input CRS): centred on the middle of the box,
/// the origin rounded to 1e-7 degrees, or to whole metres for plain input, so that text holds it exactly.
/// Throws bad_input when PROJ refuses the centre.
LocalFrame frame_centred_on(const Crs& crs, const Box& bounds);

/// Input CRS <-> local frame. Keeps a reference to `crs`, which has to outlive it.
class FieldProjection {
 public:
  /// Precondition: frame.geodetic == !crs.plain().
  FieldProjection(const Crs& crs, const LocalFrame& frame);

  const LocalFrame& frame() const { return frame_; }
  const Crs& crs() const { return *crs_; }
  /// nullopt where PROJ refuses the point.
  std::optional<Point> to_local(Point input) const;
  /// Throws failure for points far outside the frame.
  Point to_input(Point local_m) const;
  /// Throws failure when the frame is plain metres.
  Point to_lonlat(Point local_m) const;

 private:
  const Crs* crs_;
  LocalFrame frame_;
  std::optional<FrameProjection> projection_;
};

}  // namespace tramline
