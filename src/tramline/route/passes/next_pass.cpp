#include "tramline/route/passes/next_pass.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>
#include <utility>

#include "tramline/route/passes/meet_nearer.h"
#include "tramline/route/passes/pass_entries.h"

namespace tramline {
namespace {

/// Of the entries of the nearest passes so many are tried for room, the quickest first.
constexpr std::size_t kMostTried = 120;
/// Where none of them has direct room, so many are looked for along the lines of the roadmap; where these
/// have none either, so many of every pass and sense.
constexpr std::size_t kMostSearched = 12;
constexpr std::size_t kSearchedOfEach = 8;

/// Of the choices of every pass some, by their places.
std::vector<std::size_t> evenly_spread(const std::vector<EntryChoice>& all) {
  std::vector<std::size_t> out;
  for (std::size_t first = 0, next = 0; first < all.size(); first = next) {
    while (next < all.size() && all[next].pass == all[first].pass) ++next;
    const std::size_t step = std::max<std::size_t>(1, (next - first) / (2 * kSearchedOfEach));
    for (std::size_t i = first; i < next; i += step) out.push_back(i);
  }
  return out;
}

}  // namespace

NextPass::NextPass(const PassTask& task, Foresight foresight)
    : task_(task), worked_(task.passes.size(), false) {
  if (foresight == Foresight::kAhead) ahead_.emplace(task);
}

void NextPass::work(std::size_t pass) { worked_ = worked_with(pass); }

std::vector<bool> NextPass::worked_with(std::size_t pass) const {
  const auto at = std::ranges::find(task_.passes, pass);
  assert(at != task_.passes.end());
  std::vector<bool> out = worked_;
  out[static_cast<std::size_t>(at - task_.passes.begin())] = true;
  return out;
}

WorkedPass NextPass::first() const {
  const std::size_t pass = choices().all.front().pass;
  return {pass, task_.entries[pass].front(), {}};
}

NextPass::Chosen NextPass::after(const SteeredPath& left) const {
  assert(!left.empty());
  const Choices& choices = this->choices();
  NearestEntries nearest(end_of(left), task_.least, choices.all,
                         [&](std::size_t i) { return more_s(choices, i); });
  Chosen best;
  double best_s = std::numeric_limits<double>::infinity();
  for (std::size_t rank = 0; rank < std::min(nearest.size(), kMostTried); ++rank) {
    const EntryChoice& one = nearest.at(rank);
    if (one.least_s >= best_s) break;
    std::optional<Way> way = task_.connector.direct(end_of(left), one.entry->entered);
    const double ahead_s = more_s(choices, nearest.place_at(rank));
    if (!way || way->time_s + ahead_s >= best_s) continue;
    best_s = way->time_s + ahead_s;
    best = {{one.pass, *one.entry, std::move(*way)}, ahead_s};
  }
  return best_s < std::numeric_limits<double>::infinity() ? best : by_search(left, nearest, choices);
}

/// Meets the choices to which the straight line takes less than `enough_s()`, which may fall meanwhile.
template <typename Enough, typename Meet>
void NextPass::meet_sooner(const Pose& left, const Choices& choices, const Enough& enough_s,
                           const Meet& meet) const {
  const auto way_s = [&](std::size_t i) { return task_.least.crude(left, choices.all[i].entry->entered); };
  for (const Choices::Run& run : choices.runs)
    meet_nearer(run.first, run.end, run.apart_m / task_.least.fastest_mps(), way_s, enough_s, meet);
}

double NextPass::about_s(const Pose& left) const {
  const Choices& choices = this->choices();
  std::size_t nearest = 0;
  double nearest_s = std::numeric_limits<double>::infinity();
  meet_sooner(
      left, choices, [&] { return nearest_s; },
      [&](std::size_t i, double way_s) {
        nearest = i;
        nearest_s = way_s;
      });
  double out = nearest_s + more_s(choices, nearest);
  meet_sooner(
      left, choices, [&] { return out; },
      [&](std::size_t i, double way_s) { out = std::min(out, way_s + more_s(choices, i)); });
  return out;
}

void NextPass::add(const PassEntry& entry, std::size_t pass, Choices& choices) {
  const bool goes_on = !choices.all.empty() && choices.all.back().pass == pass &&
                       choices.all.back().entry->sense == entry.sense;
  if (!goes_on) choices.runs.push_back({choices.all.size(), choices.all.size(), 0});
  Choices::Run& run = choices.runs.back();
  if (goes_on)
    run.apart_m = std::max(run.apart_m, distance(choices.all.back().entry->entered.at, entry.entered.at));
  choices.all.push_back({pass, &entry});
  run.end = choices.all.size();
}

const NextPass::Choices& NextPass::choices() const {
  Choices& out = choices_[worked_];
  if (!out.all.empty()) return out;
  if (ahead_) out.least_s = ahead_->least_s(worked_);
  for (std::size_t place = 0; place < worked_.size(); ++place) {
    if (worked_[place] || !has_its_turn(task_, worked_, place)) continue;
    for (const PassEntry& entry : task_.entries[task_.passes[place]]) add(entry, task_.passes[place], out);
  }
  out.more_s.resize(out.all.size());
  return out;
}

double NextPass::more_s(const Choices& choices, std::size_t i) const {
  if (!ahead_) return 0;
  std::optional<double>& known = choices.more_s[i];
  if (!known) {
    const EntryChoice& one = choices.all[i];
    known = std::max(0.0, ahead_->onward_s(worked_with(one.pass), one.entry->left.at) - choices.least_s);
  }
  return *known;
}

NextPass::Chosen NextPass::by_search(const SteeredPath& left, NearestEntries& nearest,
                                     const Choices& choices) const {
  std::vector<std::size_t> some;
  for (std::size_t rank = 0; rank < std::min(nearest.size(), kMostSearched); ++rank) {
    nearest.at(rank);
    some.push_back(nearest.place_at(rank));
  }
  Chosen out = to_any(left, choices, some);
  if (out.pass.before.has_room()) return out;
  Chosen farther = to_any(left, choices, evenly_spread(choices.all));
  return farther.pass.before.has_room() ? farther : out;
}

NextPass::Chosen NextPass::to_any(const SteeredPath& left, const Choices& choices,
                                  const std::vector<std::size_t>& some) const {
  std::vector<SteeredPath> entered;
  for (const std::size_t i : some)
    entered.push_back(axle_path(task_.headland.passes[choices.all[i].pass], *choices.all[i].entry,
                                task_.connector.ground().machine().turning));
  Connector::WayToOne found = task_.connector.to_any(left, entered);
  const std::size_t chosen = some[found.chosen];
  const EntryChoice& choice = choices.all[chosen];
  return {{choice.pass, *choice.entry, std::move(found.way)}, more_s(choices, chosen)};
}

}  // namespace tramline
