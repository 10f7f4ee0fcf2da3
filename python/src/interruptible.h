#pragma once
// Searches that Ctrl-C ends, and whose progress a function of Python may follow.

#include <pybind11/pybind11.h>

#include <exception>
#include <functional>
#include <optional>
#include <utility>

#include "tramline/planner/progress.h"

namespace tramline::python {

/// Called with (done, total). False ends the search with the best plan found so far.
using PyProgress = std::optional<std::function<pybind11::object(int, int)>>;

/// Ends a search whose cause lies in Python.
class EndedByPython : public std::exception {};

/// Calls work(progress) without the interpreter's lock. What a signal handler or `told` raises ends the
/// search and is raised in turn. Needs the lock.
template <class Work>
auto interruptible(const PyProgress& told, const Work& work) {
  std::optional<pybind11::error_already_set> raised;
  const Progress progress = [&](int done, int total) {
    const pybind11::gil_scoped_acquire locked;
    try {
      // Signals are handled on the main thread; elsewhere this does nothing.
      if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
      if (told && (*told)(done, total).is(pybind11::bool_(false))) return Demand::kEnd;
      return Demand::kGoOn;
    } catch (pybind11::error_already_set& error) {
      if (!raised) raised.emplace(std::move(error));
      throw EndedByPython();
    }
  };
  try {
    const pybind11::gil_scoped_release unlocked;
    return work(progress);
  } catch (const EndedByPython&) {
    throw pybind11::error_already_set(std::move(*raised));
  }
}

}  // namespace tramline::python
