#pragma once
// Ways from the end of one work to the beginning of the next, with room for the machine.

#include <optional>
#include <vector>

#include "tramline/route/connection/driving_ground.h"
#include "tramline/route/connection/roadmap_ways.h"
#include "tramline/route/connection/way.h"
#include "tramline/route/connection/way_search.h"

namespace tramline {

/// What is asked of ways besides room.
struct WayTerms {
  double towing_error_m = 0;  ///< as PlanSettings
  double stop_s = 0;          ///< to back out of an end or into a beginning counts so much besides its time
};

/// Finds ways. One object serves one thread (RoadmapWays).
class Connector {
 public:
  /// Ground and roadmap outlive the connector.
  Connector(const DrivingGround& ground, RoadmapOnDemand& roadmap, const WayTerms& terms)
      : ground_(ground), roadmap_(roadmap), terms_(terms) {}

  /// The way from the end of one axle path to the beginning of another. In this order: a turn before the ends
  /// of the tracks; the way of least cost along the lines of the roadmap and between them, back out of the
  /// end or back into the beginning where that is quicker or nothing else has room, a few radii first and
  /// then as far as the two paths reach; the shortest way without room, with what it lacks. What `left` has
  /// before the work, the way that led there, may be backed along too. Preconditions: both have a length.
  Way between(const SteeredPath& left, const SteeredPath& entered) const;

  /// The same without backing, where that has room.
  std::optional<Way> without_backing(const SteeredPath& left, const SteeredPath& entered) const;

  /// `left`, come straight on to by a few radii: what the machine may back along where it is not known yet
  /// how it came.
  SteeredPath come_straight_on(const SteeredPath& left) const;

  /// between(), or where that has no room the way that backs out along come_straight_on(): out of an arm in
  /// which the machine cannot turn round, by the way it came in.
  Way between_as_come(const SteeredPath& left, const SteeredPath& entered) const;

  /// The quickest way between poses without detours or reversing, where one has room: a shortest Dubins word
  /// that leads forward, between the straight lines on which the implement is lifted and lowered.
  std::optional<Way> direct(const Pose& left, const Pose& entered) const;

  /// The way of least cost to any of several beginnings, and which: as between(), but for the turn.
  /// Precondition: `entered` is not empty.
  struct WayToOne {
    std::size_t chosen = 0;
    Way way;
  };
  WayToOne to_any(const SteeredPath& left, const std::vector<SteeredPath>& entered) const;

  /// A way of less cost that backs less far out of the one path or into the other, or else the way itself: a
  /// way is found with a few distances to back, and this one with what lies between two of these.
  /// Precondition: the way leads from `left` to `entered`, neither of them empty, and has room.
  Way with_less_backing(const Way& way, const SteeredPath& left, const SteeredPath& entered) const;

  /// The way with what it lacks of room found to kMissingRoom_m. Of ways that are compared a tenth of it may
  /// be missed, because finding all of it takes long.
  Way measured(Way way) const;

  /// As between() from a place, with any heading, or to one: at a gate. It backs no farther than it has to.
  Way from_gate(Point gate, const SteeredPath& entered) const;
  Way to_gate(const SteeredPath& left, Point gate) const;

  const DrivingGround& ground() const { return ground_; }
  const WayTerms& terms() const { return terms_; }

 private:
  struct Limit {
    double no_more_than_s = kAnyCost_s;
    std::size_t* end = nullptr;  ///< set to the index of the end found
  };
  std::optional<Way> turn(const SteeredPath& left, const SteeredPath& entered) const;
  std::optional<Way> searched(const std::vector<WayEnd>& begins, const std::vector<WayEnd>& ends,
                              const Limit& limit) const;
  /// All ways to begin works, and which of them each begins.
  struct Ends {
    std::vector<WayEnd> ends{};
    std::vector<std::size_t> of{};
  };
  enum class Backing { kNear, kFar };
  Ends ends_of(const std::vector<SteeredPath>& entered, Backing backing) const;
  /// Where both ends lead off.
  std::optional<WayToOne> without_backing(const SteeredPath& left,
                                          const std::vector<SteeredPath>& entered) const;
  /// The way without backing where there is one; with a little of it where that takes long, with as
  /// much as it takes where there is none.
  std::optional<WayToOne> without_or_with_backing(const SteeredPath& left,
                                                  const std::vector<SteeredPath>& entered) const;
  bool leads_off(const Pose& pose) const;
  Way without_room(const WayEnd& begin, const WayEnd& end) const;
  Way finished(LegKind kind, SteeredPath path) const;
  WayEnd straight_out(const Pose& end) const;
  /// Where the implement is lifted or lowered there may be no land any more.
  bool has_room(const WayEnd& straight) const;
  WayEnd straight_in(const Pose& start) const;
  /// The distances backed over a path, m: the shorter ones first, no more than its length.
  std::vector<double> backed_m(double length_m, Backing backing) const;
  /// What it counts to back so far, changes of gear and the stop included.
  double backing_s(double back_m) const;
  std::vector<WayEnd> ways_out(const SteeredPath& left, Backing backing) const;
  std::vector<WayEnd> ways_in(const SteeredPath& entered, Backing backing) const;
  /// Ends that are backed to by less than on the way that was found, and by as much; the end itself where it
  /// does not back there.
  std::vector<WayEnd> less_backed_out(const Way& way, const SteeredPath& left) const;
  std::vector<WayEnd> less_backed_in(const Way& way, const SteeredPath& entered) const;
  /// The way, or where it backs at an end a quicker one between these ends.
  Way or_quicker(Way way, const std::vector<WayEnd>& begins, const std::vector<WayEnd>& ends) const;
  WayEnd backed_out(const SteeredPath& left, double back_m) const;
  WayEnd backed_in(const SteeredPath& entered, double back_m) const;
  /// Distances in even steps from the one tried before `back_m` up to it.
  std::vector<double> up_to_m(double back_m, double length_m) const;

  const DrivingGround& ground_;
  RoadmapOnDemand& roadmap_;
  WayTerms terms_;
};

}  // namespace tramline
