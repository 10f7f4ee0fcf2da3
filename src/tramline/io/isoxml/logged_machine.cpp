#include "tramline/io/isoxml/logged_machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace tramline::io {
namespace {

constexpr double kTouching_m = 1e-3;

}  // namespace

LoggedMachine::LoggedMachine(const TimeLogHeader& header, const std::vector<DeviceElement>& elements)
    : logged_(logged_devices(header, elements)),
      tree_(logged_.elements),
      values_(header, tree_),
      states_(tree_, values_),
      rate_(header, logged_.elements),
      parts_logged_(tree_.size()) {
  for (std::size_t i = 0; i < tree_.size(); ++i) parts_logged_[i] = parts_are_logged(i);
}

/// Widths or states of what the element is made of, rather than of itself.
bool LoggedMachine::parts_are_logged(std::size_t element) const {
  for (const std::size_t part : tree_.children(element)) {
    if (values_.is_logged(part, ddi::kActualWidth) || parts_are_logged(part)) return true;
    if (is_small_part(tree_[part]) && !states_.sources_of(part).empty() &&
        states_.sources_of(part) != states_.sources_of(element))
      return true;
  }
  return false;
}

ElementValues LoggedMachine::element_values() const {
  return {[this](std::size_t element, unsigned identifier) { return values_.value(element, identifier); },
          [this](std::size_t element) { return values_.logged(element, ddi::kActualWidth).has_value(); },
          [this](std::size_t element) -> bool { return parts_logged_[element]; }};
}

void LoggedMachine::update(const TimeLogRecord& record) {
  rate_.update(record);
  const LoggedValues::Change change = values_.update(record);
  if (change.places) pieces_.reset();
  if (change.places || change.states) described_.reset();
}

/// Sources that all elements have in common, or, where none has any, the first state of another element.
void LoggedMachine::find_common_sources(const std::vector<std::size_t>& elements) {
  common_.clear();
  bool any = false;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const std::vector<StateSource> sources = states_.sources_of(elements[i]);
    any = any || !sources.empty();
    if (i == 0) common_ = sources;
    std::erase_if(common_, [&](const StateSource& source) {
      return std::find(sources.begin(), sources.end(), source) == sources.end();
    });
  }
  for (std::size_t i = 0; i < tree_.size() && !any; ++i) {
    if (!values_.is_logged(i, ddi::kWorkState)) continue;
    common_ = {{i, StateSource::Kind::kWorkState, 0}};
    any = true;
  }
}

/// Row units without a state of their own are switched with their section.
std::size_t LoggedMachine::bearer_of(std::size_t element) const {
  const std::vector<StateSource> own = states_.sources_of(element);
  std::size_t out = element;
  for (auto at = tree_.parent(element); at && tree_[out].type == element_kind::kUnit;
       at = tree_.parent(*at)) {
    if (states_.sources_of(*at) != own) break;
    out = *at;
  }
  return out;
}

void LoggedMachine::find_bearers(const std::vector<std::size_t>& elements) {
  bearers_.clear();
  std::set<std::optional<std::size_t>> switched;  // wholes of which parts have states of their own
  for (const std::size_t element : elements) {
    Bearer bearer;
    for (const StateSource& source : states_.sources_of(element))
      if (std::find(common_.begin(), common_.end(), source) == common_.end())
        bearer.sources.push_back(source);
    if (!bearer.sources.empty()) switched.insert(tree_.parent(element));
    bearers_.emplace(element, std::move(bearer));
  }
  for (auto& [element, bearer] : bearers_)
    bearer.follows = bearer.sources.empty() && !switched.contains(tree_.parent(element));
}

/// The sections, else all elements: what has states where nothing has a width.
std::vector<std::size_t> LoggedMachine::without_width() const {
  std::vector<std::size_t> sections, all;
  for (std::size_t i = 0; i < tree_.size(); ++i) {
    all.push_back(i);
    if (tree_[i].type == element_kind::kSection) sections.push_back(i);
  }
  return sections.empty() ? all : sections;
}

void LoggedMachine::find_pieces() {
  std::vector<WorkingPart> parts = working_parts(tree_, element_values());
  std::stable_sort(parts.begin(), parts.end(), [](const WorkingPart& a, const WorkingPart& b) {
    return a.place.left_m > b.place.left_m;
  });
  std::vector<std::size_t> elements;
  for (WorkingPart& part : parts) {
    part.element = bearer_of(part.element);
    elements.push_back(part.element);
  }
  if (elements.empty()) elements = without_width();
  find_common_sources(elements);
  find_bearers(elements);
  const bool as_one = std::all_of(bearers_.begin(), bearers_.end(),
                                  [](const auto& bearer) { return bearer.second.sources.empty(); });
  pieces_.emplace();
  std::map<std::size_t, std::size_t> last;  // piece of each bearer that is furthest right
  for (const WorkingPart& part : parts) {
    const auto [at, is_new] = last.try_emplace(as_one ? 0 : part.element, pieces_->size());
    if (!is_new && (*pieces_)[at->second].place.right_m - part.place.left_m <= kTouching_m) {
      Section& so_far = (*pieces_)[at->second].place;
      so_far.right_m = std::min(so_far.right_m, part.place.right_m);
      continue;
    }
    at->second = pieces_->size();
    pieces_->push_back({part.place, part.element});
  }
  if (pieces_->size() <= kMostSections) return;
  pieces_->resize(kMostSections);
  const std::string note =
      fmt::format("the machine has more than {} sections; those further right are left out", kMostSections);
  if (std::find(notes_.begin(), notes_.end(), note) == notes_.end()) notes_.push_back(note);
}

void LoggedMachine::describe(Fix& fix, BoomList& booms) {
  if (!described_) describe_anew(described_.emplace(), booms);
  fix.work = described_->work;
  fix.boom = described_->boom;
  fix.has_sections = described_->has_sections;
  fix.sections = described_->sections;
  fix.rate_per_ha = rate_.per_ha();
}

void LoggedMachine::describe_anew(Fix& fix, BoomList& booms) {
  if (!pieces_) find_pieces();
  const std::optional<bool> common = states_.state(common_);
  std::map<std::size_t, std::optional<bool>> known;
  bool any_known = false, any_on = false;
  for (const auto& [element, bearer] : bearers_) {
    const std::optional<bool> on = states_.state(bearer.sources);
    known[element] = on;
    any_known = any_known || on.has_value();
    any_on = any_on || on.value_or(false);
  }
  const bool works = common.value_or(any_on);
  if (common || any_known) fix.work = works ? WorkState::kOn : WorkState::kOff;
  if (pieces_->empty()) {
    // Widths that are logged as nothing are a machine that works nothing; none at all, one not known.
    bool any_width = false;
    const ElementValues values = element_values();
    for (std::size_t i = 0; i < tree_.size(); ++i) any_width = any_width || width_of(i, values).has_value();
    if (any_width) fix.boom = booms.number_of({});
    return;
  }
  Boom boom;
  for (const Piece& piece : *pieces_) boom.push_back(piece.place);
  fix.boom = booms.number_of(boom);
  fix.has_sections = any_known;
  for (std::size_t i = 0; i < pieces_->size() && any_known; ++i) {
    const std::size_t element = (*pieces_)[i].bearer;
    fix.sections[i] = bearers_.at(element).follows ? works : known.at(element).value_or(false);
  }
}

std::vector<std::string> LoggedMachine::notes() const {
  std::vector<std::string> out = logged_.notes;
  out.insert(out.end(), notes_.begin(), notes_.end());
  if (!rate_.note().empty()) out.push_back(rate_.note());
  return out;
}

}  // namespace tramline::io
