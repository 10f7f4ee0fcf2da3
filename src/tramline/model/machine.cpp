#include "tramline/model/machine.h"

namespace tramline {

const char* name(Coupling coupling) { return coupling == Coupling::kTowed ? "towed" : "mounted"; }

std::optional<Coupling> coupling_named(std::string_view word) {
  for (const Coupling coupling : {Coupling::kMounted, Coupling::kTowed})
    if (word == name(coupling)) return coupling;
  return std::nullopt;
}

}  // namespace tramline
