#include "server/http/http_error.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "report/report_parts.h"
#include "server/http/page_words.h"
#include "tramline/geometry/error.h"

namespace tramline::server {

int status_of(Fault fault) {
  switch (fault) {
    case Fault::kBadInput:
      return 400;
    case Fault::kForbidden:
      return 403;
    case Fault::kNotFound:
      return 404;
    case Fault::kConflict:
      return 409;
    case Fault::kTooLarge:
      return 413;
    case Fault::kFailed:
      return 500;
    case Fault::kBusy:
      return 503;
  }
  return 500;
}

const char* word_of(Fault fault) {
  switch (fault) {
    case Fault::kBadInput:
      return "bad_input";
    case Fault::kForbidden:
      return "forbidden";
    case Fault::kNotFound:
      return "not_found";
    case Fault::kConflict:
      return "conflict";
    case Fault::kTooLarge:
      return "too_large";
    case Fault::kFailed:
      return "failed";
    case Fault::kBusy:
      return "busy";
  }
  return "failed";
}

HttpError not_found(const std::string& what, const std::string& id) {
  return {Fault::kNotFound,
          fmt::format("there is no {} '{}'; it may have been deleted: choose another", what, id)};
}

Answer answer_to(const std::exception_ptr& problem) {
  try {
    std::rethrow_exception(problem);
  } catch (const HttpError& error) {
    return {error.fault(), error.what()};
  } catch (const Error& error) {
    const bool ours = error.kind() == ErrorKind::kFailure;
    return {ours ? Fault::kFailed : Fault::kBadInput, in_page_words(error.what())};
  } catch (const std::bad_alloc&) {
    return {Fault::kFailed, "this is too much for the memory of this computer; try with less"};
  } catch (const std::exception& error) {
    return {Fault::kFailed, fmt::format("something went wrong within the program: {}", error.what())};
  } catch (...) {
    return {Fault::kFailed, "something went wrong within the program"};
  }
}

std::string error_body(Fault fault, const std::string& sentence) {
  return app::json_line({{"error", {{"code", word_of(fault)}, {"message", sentence}}}});
}

}  // namespace tramline::server
