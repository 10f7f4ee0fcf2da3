#include "tramline/model/headland.h"

namespace tramline {

double length(const Headland& headland) {
  double sum = 0;
  for (const HeadlandPass& pass : headland.passes) sum += length(pass.path);
  return sum;
}

}  // namespace tramline
