#pragma once
// The one exception type of the library. See docs/adr/0003-one-error-type.md.

#include <stdexcept>
#include <string>

namespace tramline {

enum class ErrorKind {
  kBadInput,  ///< the user's file or option is at fault: the program exits with 2
  kFailure,   ///< the input was fine but the run failed (disk full, no such driver): exits with 1
};

/// What went wrong, in one sentence that names the place in the user's input and what to do about it.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& sentence) : std::runtime_error(sentence), kind_(kind) {}
  ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

inline Error bad_input(const std::string& sentence) { return Error(ErrorKind::kBadInput, sentence); }
inline Error failure(const std::string& sentence) { return Error(ErrorKind::kFailure, sentence); }

}  // namespace tramline
