#pragma once
// Sets of lines that a solution of the relaxation hardly connects with the rest.

#include <cstddef>
#include <vector>

namespace tramline::testing {

/// How strongly a solution connects lines with one another.
class WeightedLines {
 public:
  explicit WeightedLines(std::size_t lines) : weights_(lines, std::vector<double>(lines, 0)) {}

  void add(std::size_t a, std::size_t b, double weight) {
    weights_[a][b] += weight;
    weights_[b][a] += weight;
  }

  /// Sets of lines whose connections with all others weigh less than `least`, by line whether it is in the
  /// set: among them one, if there is any. They are those that the minimum cuts of Stoer and Wagner (1997)
  /// find on the way. O(n³).
  std::vector<std::vector<bool>> sets_cut_below(double least) const;

 private:
  std::vector<std::vector<double>> weights_;
};

}  // namespace tramline::testing
