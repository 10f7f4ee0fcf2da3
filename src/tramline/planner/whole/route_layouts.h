#pragma once
// The plans whose routes are worth comparing, without their routes.

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "tramline/planner/headland_choice/headland_trial.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/planning_problem.h"
#include "tramline/planner/search_context.h"

namespace tramline {

/// In fields with no more obstacles the headland of each of them is tried by itself.
inline constexpr std::size_t kFewObstacles = 6;

/// Tracks behind headlands, without a route.
struct LaidOut {
  Alternative kind = Alternative::kSearched;
  HeadlandTrial trial;
};

/// Whether all subfields of a plan have straight tracks in this direction.
bool all_in(const Plan& plan, Direction direction);

/// Whether two plans have as many subfields with the same straight directions, in whatever order.
bool same_directions(const Plan& a, const Plan& b);

/// Whether the field is so narrow, or so small, that the passes work more of it than tracks.
bool passes_work_most(const PreparedField& prepared);

/// Lays tracks out for one problem. All functions are deterministic for any number of threads; one object
/// serves one thread, because it keeps the land behind passes that it has prepared.
class RouteLayouts {
 public:
  /// `layouts` as of cheapest_route(). They outlive this.
  RouteLayouts(const PlanningProblem& problem, const std::vector<Plan>& layouts,
               const SearchContext& context);

  /// Passes round the field as deep as half a circle of the machine and what reaches ahead of its axle.
  int least_passes() const { return least_passes_; }
  /// In a round field without obstacles: about as many passes all round as work it without tracks, like a
  /// disc from its rim to its centre; else 0. The depths between these and the least may all cost more.
  int passes_alone() const;
  /// By obstacle: as many as turns need; where all tracks go round it 0, or the least passes in a field of
  /// few obstacles.
  std::vector<int> passes_round_all() const;

  /// No passes round any obstacle, where that may be chosen, in a field of few obstacles.
  std::optional<std::vector<int>> none_round_obstacles() const;

  /// The curved layouts, or curves behind the passes where these follow from turns, the tracks of least cost,
  /// and those along the longest side and the length of the
  /// field, behind the passes asked for, or behind the least passes all round; the same without the headlands
  /// of obstacles that follow from turns, and with passes_round_all().
  std::vector<LaidOut> to_begin_with();
  /// The layouts, and tracks along the longest side and the length of the field, behind passes where their
  /// tracks end; none where the passes are given.
  std::vector<LaidOut> behind_open_passes();

  /// Whether these passes leave other land than all others asked for before: where there is no room for more,
  /// more are the same.
  bool leave_other_land(const PassesByBoundary& passes);

  PassesByBoundary all_round(int passes, const std::vector<int>& obstacles) const;
  /// The tracks of least cost behind these passes, and the undivided ones where these are several subfields;
  /// the passes alone where they leave no room for tracks.
  std::vector<LaidOut> searched(const PassesByBoundary& passes);
  /// Whether those behind these passes were asked for.
  bool has_searched(const PassesByBoundary& passes) const;

  /// Tracks along curves behind these passes, where the settings leave their shape to the planner: those of
  /// least cost along edges of the land there, and those in some parts of it where that costs less than
  /// straight ones. None where no edge of the land and of its parts is a curve.
  std::vector<LaidOut> along_curves(const PassesByBoundary& passes);
  /// Whether curves behind these passes were asked for, or need not be.
  bool looked_for_curves(const PassesByBoundary& passes) const;

  /// Tracks along the longest side and the length of the field behind these passes.
  std::vector<LaidOut> along_sides(const PassesByBoundary& passes);

  /// The straight tracks of least cost behind these passes by the usual prices of tracks (Objective) instead
  /// of those of the problem, by which a turn mostly costs less; nullopt where no track fits.
  std::optional<Plan> best_by_usual_prices(const PassesByBoundary& passes);

  /// The directions and curves of a plan laid anew behind these passes; nullopt where no track fits.
  std::optional<LaidOut> laid_out(Alternative kind, const Plan& like, const PassesByBoundary& passes);

 private:
  /// The field behind passes; `prepared` is nothing where they leave no land for tracks, unless
  /// they work most of the field themselves.
  struct Behind {
    PassesByBoundary passes;
    PlanningProblem problem;
    std::shared_ptr<const PreparedField> prepared;
  };

  struct Job {
    Alternative kind;
    Plan layout;
    PassesByBoundary passes{};
  };

  template <class Found>
  using ByPasses = std::vector<std::pair<PassesByBoundary, Found>>;

  PassesByBoundary no_passes() const;
  /// `problem_` with these passes, and the land behind them.
  Behind prepared_behind(const PassesByBoundary& passes) const;
  const Behind& behind(const PassesByBoundary& passes);
  /// The straight tracks of least cost behind these passes, looked for once. Precondition: there is land.
  const SearchResult& straight_on(const Behind& behind);
  std::optional<Plan> searched_by_usual_prices(const PassesByBoundary& passes);
  std::optional<LaidOut> laid_out_on(const Behind& behind, Alternative kind, const Plan& like) const;
  /// The passes that turns need where the tracks of a layout on the bare field end.
  PassesByBoundary where_tracks_end(const Plan& layout) const;
  /// The layout behind passes where its tracks end; one without tracks gets them on the bare field first.
  std::optional<LaidOut> where_it_ends(Alternative kind, const Plan& layout) const;
  /// One layout along the longest side of the field and one along its length, without tracks, as far as none
  /// of the known ones is the same.
  std::vector<Job> along_the_field(const std::vector<LaidOut>& known) const;

  PlanningProblem problem_;  ///< without turns
  const std::vector<Plan>& layouts_;
  SearchContext context_;  ///< without the sweep, in whose cells curves are looked for
  SearchContext sweeping_;
  int least_passes_ = 0;
  std::vector<std::unique_ptr<const Behind>> kept_;
  std::vector<PassesByBoundary> searched_;  ///< behind which straight tracks were asked for
  ByPasses<SearchResult> straight_;
  ByPasses<std::optional<Plan>> by_usual_prices_;
  std::vector<PassesByBoundary> curved_;          ///< behind which curves were looked for
  std::optional<PassesByBoundary> first_open_{};  ///< where the tracks of the first layout end, if known
  std::vector<int> obstacle_passes_;              ///< as many as turns need, 0 where all tracks go round
};

}  // namespace tramline
