#pragma once
// A front with the request it was computed for.

#include <nlohmann/json.hpp>
#include <string>

#include "server/store/field_store.h"
#include "tramline/planner/pareto/trade_off.h"

namespace tramline::server {

struct KeptFront {
  std::string id;
  std::string name;
  KeptFieldPtr field;
  Machine machine;
  PlanSettings settings;
  TradeOff found;
  double seconds = 0;
  nlohmann::ordered_json asked{};  ///< see PlanNotes
};

}  // namespace tramline::server
