#include "tramline/route/build/pair_costs.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace tramline {
namespace {

constexpr unsigned kFirstBits = 10;

}  // namespace

void PairCosts::change(order::End a, order::End b, double cost_s) {
  Entry& entry = entries_[place_of(pair_of(a, b))];
  if (entry.pair != kNone) entry.cost_s = cost_s;
}

PairCosts::PairCosts(std::size_t expected) {
  resize(std::max(kFirstBits, static_cast<unsigned>(std::bit_width(2 * expected))));
}

void PairCosts::clear() { resize(64 - shift_); }

void PairCosts::resize(unsigned bits) {
  entries_.assign(std::size_t{1} << bits, Entry{});
  count_ = 0;
  shift_ = 64 - bits;
}

void PairCosts::grow() {
  const std::vector<Entry> before = std::exchange(entries_, {});
  const std::size_t count = count_;
  resize(64 - shift_ + 1);
  for (const Entry& entry : before)
    if (entry.pair != kNone) entries_[place_of(entry.pair)] = entry;
  count_ = count;
}

}  // namespace tramline
