#include "tramline/io/isoxml/working_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/io/isoxml/unit_rows.h"

namespace tramline::io {
namespace {

constexpr double kMillimetre = 1e-3;
/// Offsets closer than this are the same across; along the machine, tools stand further apart.
constexpr double kSamePlace_m = 1e-3, kBehind_m = 0.05;

/// What one part of a whole works, and how sure its place is.
struct Group {
  std::size_t element = 0;
  std::vector<WorkingPart> parts;
  bool placed = false;  ///< by an offset, its own or that of a part
};

Section span_of(const std::vector<WorkingPart>& parts) {
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  Section out{-kNowhere, kNowhere};
  for (const WorkingPart& part : parts) {
    out.left_m = std::max(out.left_m, part.place.left_m);
    out.right_m = std::min(out.right_m, part.place.right_m);
  }
  return out;
}

double width_m(const Section& place) { return place.left_m - place.right_m; }
double middle_m(const Group& group) {
  const Section span = span_of(group.parts);
  return 0.5 * (span.left_m + span.right_m);
}

void shift(Group& group, double left_m) {
  for (WorkingPart& part : group.parts)
    part.place = {part.place.left_m + left_m, part.place.right_m + left_m};
}

bool works_ground(const DeviceElement& element) {
  return element.type != element_kind::kBin && element.type != element_kind::kConnector &&
         element.type != element_kind::kNavigation;
}

class PartsOfTree {
 public:
  PartsOfTree(const DeviceTree& tree, const ElementValues& values) : tree_(tree), values_(values) {}

  /// `elements`: the parts of one whole, which `whole` is unless they are the roots of a device.
  std::vector<Group> groups_of(const std::vector<std::size_t>& elements,
                               std::optional<std::size_t> whole) const {
    std::vector<Group> out;
    std::vector<std::size_t> without_width;
    for (const std::size_t element : elements) {
      if (!works_ground(tree_[element])) continue;
      Group group = group_of(element);
      if (!group.parts.empty())
        out.push_back(std::move(group));
      else if (is_small_part(tree_[element]) && !width_of(element, values_))
        without_width.push_back(element);
    }
    share_rest(out, without_width, whole);
    std::stable_sort(out.begin(), out.end(), [&](const Group& a, const Group& b) {
      return tree_[a.element].number < tree_[b.element].number;
    });
    place(out, whole);
    return out;
  }

 private:
  std::optional<double> offset_m(std::size_t element, unsigned identifier) const {
    const auto offset = values_.value(element, identifier);
    if (!offset || std::abs(static_cast<double>(*offset)) > kWidestMachine_m / kMillimetre)
      return std::nullopt;
    return static_cast<double>(*offset) * kMillimetre;
  }

  /// Left of the reference point, where the offset counts to the right.
  double left_of_reference_m(std::optional<std::size_t> element) const {
    return element ? -offset_m(*element, ddi::kOffsetY).value_or(0) : 0;
  }

  Group of_width(std::size_t element, double width) const {
    Group out{element, {}, offset_m(element, ddi::kOffsetY).has_value()};
    if (!(width > 0)) return out;
    const double left_m = left_of_reference_m(element);
    out.parts.push_back({element, {left_m + 0.5 * width, left_m - 0.5 * width}});
    return out;
  }

  Group group_of(std::size_t element) const {
    const std::optional<double> own = width_of(element, values_);
    if (own && values_.width_logged(element) && !values_.parts_logged(element))
      return of_width(element, *own);
    Group out{element, {}, offset_m(element, ddi::kOffsetY).has_value()};
    for (Group& part : groups_of(tree_.children(element), element)) {
      out.placed = out.placed || part.placed;
      out.parts.insert(out.parts.end(), part.parts.begin(), part.parts.end());
    }
    return out.parts.empty() && own ? of_width(element, *own) : out;
  }

  /// Sections and units without a width: an equal share of what the others leave of the whole.
  void share_rest(std::vector<Group>& groups, const std::vector<std::size_t>& without_width,
                  std::optional<std::size_t> whole) const {
    if (without_width.empty() || !whole) return;
    const std::optional<double> all_m = width_of(*whole, values_);
    double rest_m = all_m.value_or(0);
    for (const Group& group : groups) rest_m -= width_m(span_of(group.parts));
    if (!(rest_m > kSamePlace_m)) return;
    for (const std::size_t element : without_width)
      groups.push_back(of_width(element, rest_m / static_cast<double>(without_width.size())));
  }

  void place(std::vector<Group>& groups, std::optional<std::size_t> whole) const {
    if (groups.empty()) return;
    const bool all_placed =
        std::all_of(groups.begin(), groups.end(), [](const Group& group) { return group.placed; });
    const bool all_at_one_place = std::all_of(groups.begin(), groups.end(), [&](const Group& group) {
      return std::abs(middle_m(group) - middle_m(groups.front())) < kSamePlace_m;
    });
    const bool told = all_placed && (groups.size() == 1 || !all_at_one_place);
    const bool in_line = !told && (groups.size() == 1 || stand_in_line(groups, whole));
    if (!told && !in_line) stand_side_by_side(groups, left_of_reference_m(whole));
    if (in_line)
      for (Group& group : groups)
        if (!group.placed) shift(group, left_of_reference_m(whole) - middle_m(group));
    close_rows(groups);
  }

  bool stand_in_line(const std::vector<Group>& groups, std::optional<std::size_t> whole) const {
    if (differ_along(groups)) return true;
    double sum_m = 0, widest_m = 0;
    for (const Group& group : groups) {
      sum_m += width_m(span_of(group.parts));
      widest_m = std::max(widest_m, width_m(span_of(group.parts)));
    }
    const std::optional<double> all_m = whole ? width_of(*whole, values_) : std::nullopt;
    if (all_m && *all_m > 0) return std::abs(*all_m - widest_m) < std::abs(*all_m - sum_m);
    return std::none_of(groups.begin(), groups.end(),
                        [&](const Group& group) { return is_small_part(tree_[group.element]); });
  }

  bool differ_along(const std::vector<Group>& groups) const {
    double first = std::numeric_limits<double>::infinity(), last = -first;
    for (const Group& group : groups) {
      const std::optional<double> along_m = offset_m(group.element, ddi::kOffsetX);
      if (!along_m) return false;
      first = std::min(first, *along_m);
      last = std::max(last, *along_m);
    }
    return last - first > kBehind_m;
  }

  static void stand_side_by_side(std::vector<Group>& groups, double middle) {
    double sum_m = 0;
    for (const Group& group : groups) sum_m += width_m(span_of(group.parts));
    double left_m = middle + 0.5 * sum_m;
    for (Group& group : groups) {
      const Section span = span_of(group.parts);
      shift(group, left_m - span.left_m);
      left_m -= width_m(span);
    }
  }

  void close_rows(std::vector<Group>& groups) const {
    std::vector<Section*> rows;
    for (Group& group : groups)
      if (tree_[group.element].type == element_kind::kUnit && group.parts.size() == 1)
        rows.push_back(&group.parts.front().place);
    reach_to_next_row(rows);
  }

  const DeviceTree& tree_;
  const ElementValues& values_;
};

}  // namespace

std::optional<double> width_of(std::size_t element, const ElementValues& values) {
  for (const unsigned identifier : {ddi::kActualWidth, ddi::kMostWidth, ddi::kDefaultWidth}) {
    const auto width = values.value(element, identifier);
    if (!width) continue;
    const double metres = static_cast<double>(*width) * kMillimetre;
    return metres >= 0 && metres <= kWidestMachine_m ? std::optional(metres) : std::nullopt;
  }
  return std::nullopt;
}

std::vector<WorkingPart> working_parts(const DeviceTree& tree, const ElementValues& values) {
  std::vector<WorkingPart> out;
  const PartsOfTree parts(tree, values);
  for (const std::vector<std::size_t>& roots : tree.devices())
    for (const Group& group : parts.groups_of(roots, std::nullopt))
      out.insert(out.end(), group.parts.begin(), group.parts.end());
  return out;
}

}  // namespace tramline::io
