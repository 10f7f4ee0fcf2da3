#pragma once
// Failures of requests as answers: a status, a code for programs and a sentence for people.

#include <exception>
#include <stdexcept>
#include <string>

namespace tramline::server {

/// The codes of failures for programs, in the order of their statuses.
enum class Fault { kBadInput, kForbidden, kNotFound, kConflict, kTooLarge, kFailed, kBusy };

int status_of(Fault fault);
const char* word_of(Fault fault);

/// Thrown by handlers where an Error of the library does not say enough.
class HttpError : public std::runtime_error {
 public:
  HttpError(Fault fault, const std::string& sentence) : std::runtime_error(sentence), fault_(fault) {}
  Fault fault() const { return fault_; }

 private:
  Fault fault_;
};

HttpError not_found(const std::string& what, const std::string& id);

/// The answer to a client for an exception.
struct Answer {
  Fault fault = Fault::kFailed;
  std::string sentence;
};
/// An Error of the library is the client's fault or ours; anything else is ours.
Answer answer_to(const std::exception_ptr& problem);

/// {"error": {"code": …, "message": …}}
std::string error_body(Fault fault, const std::string& sentence);

}  // namespace tramline::server
