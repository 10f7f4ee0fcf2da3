#pragma once
// The machines of --widths and --machines.

#include <string>
#include <vector>

#include "tramline/model/machine.h"

namespace tramline::app {

/// The machine at each of the widths, or those of several machine files, separated by commas; the machine
/// itself where both texts are empty. Throws kBadInput for a width that is none, for a file as
/// io::read_machine() does, and where both are given or two machines cannot be told apart.
std::vector<Machine> machines_asked(const Machine& machine, const std::string& widths,
                                    const std::string& files);

}  // namespace tramline::app
