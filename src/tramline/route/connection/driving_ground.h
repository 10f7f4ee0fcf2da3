#pragma once
// The land that a route may use, and the part of it that is better left alone.

#include <memory>
#include <optional>
#include <vector>

#include "tramline/model/manoeuvre.h"
#include "tramline/model/plan.h"
#include "tramline/route/connection/crop_ground.h"
#include "tramline/turns/manoeuvres/turn_curve.h"
#include "tramline/turns/outline/outline.h"
#include "tramline/turns/room/allowed_land.h"

namespace tramline {

/// Prepared once for all ways of a plan. Safe to read from any number of threads.
class DrivingGround {
 public:
  /// `turning_land`: the land that the machine may turn on, passable obstacles left out. `body`: the land of
  /// the tracks.
  DrivingGround(const AllowedLand& turning_land, const Field& field, const Machine& machine,
                const Region& body);

  const Machine& machine() const { return machine_; }
  const Outline& outline() const { return outline_; }
  const AllowedLand& turning() const { return turning_; }
  /// With the passable obstacles, which are crossed straight on.
  const AllowedLand& land() const { return with_passables_ ? *with_passables_ : turning_; }

  /// The shortest ways forward between two poses, the shortest first; with clothoids where the wheels take
  /// time to be steered, and then there may be none.
  std::vector<Manoeuvre> words(const Pose& from, const Pose& to) const;
  bool steers_at_once() const { return curve_.at_once(); }
  /// Whether the wheels can be steered along lines and arcs that meet at once, with the work off: without
  /// arcs always.
  bool can_follow(const SteeredPath& path) const;

  /// Whether the outline has room on a way that turns.
  bool has_room(const SteeredPath& path) const { return turning_.fits(path, outline_); }
  /// The same for a way along a pass or a track, which may lead across passable obstacles and touch the edge
  /// of the land to a millimetre.
  bool has_room_along(const SteeredPath& path) const;

  /// How far the outline leaves the land on a way along a pass or a track, found to kMissingRoom_m, m; 0 only
  /// where it does not by more than kNoticed_m.
  double lacking_along_m(const SteeredPath& path) const;

  /// The length of the path over land of the tracks, in steps of kCropStep_m, m.
  double over_crop_m(const SteeredPath& path) const { return crop_.length_over_m(path); }

  /// What driving across land of the tracks counts besides its time, as a multiple of it.
  double more_over_crop() const { return more_over_crop_; }

 private:
  const AllowedLand& turning_;
  Machine machine_;
  Outline outline_;
  TurnCurve curve_;
  std::optional<AllowedLand> with_passables_{};
  CropGround crop_;
  double more_over_crop_;
};

inline constexpr double kNoticed_m = 0.005;

/// Driving over crop counts less along a track, whose lines are there anyway, than across the tracks.
enum class CropDriven { kAcross, kAlongTrack };

/// The time of a way, and what it costs to drive over crop, s: one drives round where that is not much
/// farther.
double cost_seconds(const SteeredPath& path, const DrivingGround& ground,
                    CropDriven how = CropDriven::kAcross);

}  // namespace tramline
