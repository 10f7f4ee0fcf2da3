#include "tramline/io/isoxml/unit_rows.h"

#include <algorithm>

namespace tramline::io {
namespace {

constexpr double kWidestRow_m = 2;
constexpr double kStillNext = 1.5;

double middle_m(const Section* row) { return 0.5 * (row->left_m + row->right_m); }

}  // namespace

void reach_to_next_row(std::vector<Section*>& rows) {
  if (rows.size() < 2) return;
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Section* a, const Section* b) { return middle_m(a) > middle_m(b); });
  std::vector<double> middles, apart;
  for (const Section* row : rows) middles.push_back(middle_m(row));
  for (std::size_t i = 1; i < rows.size(); ++i) apart.push_back(middles[i - 1] - middles[i]);
  const auto usual = apart.begin() + std::ssize(apart) / 2;
  std::nth_element(apart.begin(), usual, apart.end());
  const double row_m = *usual;
  if (!(row_m > 0) || row_m > kWidestRow_m) return;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool meets_left = i > 0 && middles[i - 1] - middles[i] <= kStillNext * row_m;
    const bool meets_right = i + 1 < rows.size() && middles[i] - middles[i + 1] <= kStillNext * row_m;
    const double left_m = meets_left ? 0.5 * (middles[i - 1] + middles[i]) : middles[i] + 0.5 * row_m;
    const double right_m = meets_right ? 0.5 * (middles[i] + middles[i + 1]) : middles[i] - 0.5 * row_m;
    rows[i]->left_m = std::max(rows[i]->left_m, left_m);
    rows[i]->right_m = std::min(rows[i]->right_m, right_m);
  }
}

}  // namespace tramline::io
