#include "tramline/io/fixes/counter_total.h"

#include <limits>

namespace tramline::io {

void CounterTotal::add(double reading) {
  if (!(reading >= 0)) return;
  if (last_) total_ = total_.value_or(0) + (reading >= *last_ ? reading - *last_ : reading);
  last_ = reading;
}

double CounterTotal::total() const { return total_.value_or(std::numeric_limits<double>::quiet_NaN()); }

}  // namespace tramline::io
