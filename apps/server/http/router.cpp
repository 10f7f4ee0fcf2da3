#include "server/http/router.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "report/report_parts.h"
#include "server/http/http_error.h"
#include "server/http/packed.h"
#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

constexpr const char* kJson = "application/json";
constexpr std::size_t kLongestPart = 64;

std::vector<std::string_view> segments(std::string_view path) {
  std::vector<std::string_view> out;
  std::size_t from = 0;
  while (from <= path.size()) {
    const std::size_t slash = std::min(path.find('/', from), path.size());
    out.push_back(path.substr(from, slash - from));
    from = slash + 1;
  }
  return out;
}

bool is_placeholder(std::string_view segment) { return segment.starts_with('{') && segment.ends_with('}'); }

/// Names of layers and formats beside ids; neither "." nor "..".
bool is_name(std::string_view segment) {
  const auto plain = [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  return !segment.empty() && segment.size() <= kLongestPart && segment.front() != '.' &&
         std::all_of(segment.begin(), segment.end(), plain);
}

std::optional<std::vector<std::pair<std::string, std::string>>> matched(std::string_view pattern,
                                                                        std::string_view path) {
  const auto wanted = segments(pattern), given = segments(path);
  if (wanted.size() != given.size()) return std::nullopt;
  std::vector<std::pair<std::string, std::string>> parts;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!is_placeholder(wanted[i])) {
      if (wanted[i] != given[i]) return std::nullopt;
      continue;
    }
    if (!is_name(given[i])) return std::nullopt;
    parts.emplace_back(wanted[i].substr(1, wanted[i].size() - 2), given[i]);
  }
  return parts;
}

HttpError too_large(std::size_t most_bytes) {
  return {Fault::kTooLarge,
          fmt::format("this is more than the {} MB that are taken here; send less", most_bytes >> 20)};
}

/// A place among the bodies that are being received.
class BodyRoom {
 public:
  explicit BodyRoom(std::counting_semaphore<kMostBodies>* bodies) : bodies_(bodies) {
    if (bodies_ != nullptr && !bodies_->try_acquire())
      throw HttpError(Fault::kBusy, fmt::format("{} requests are being received already, which is as many as "
                                                "there can be; send this one again in a while",
                                                kMostBodies));
  }
  BodyRoom(const BodyRoom&) = delete;
  BodyRoom& operator=(const BodyRoom&) = delete;
  ~BodyRoom() {
    if (bodies_ != nullptr) bodies_->release();
  }

 private:
  std::counting_semaphore<kMostBodies>* bodies_;
};

std::string_view method_of(const httplib::Request& request) {
  return request.method == "HEAD" ? std::string_view("GET") : std::string_view(request.method);
}

/// Values are copied and written by a call for each level of nesting, so that there must not be a million.
bool not_too_deep(int depth, nlohmann::ordered_json::parse_event_t, nlohmann::ordered_json&) {
  if (depth > kDeepestJson)
    throw HttpError(
        Fault::kBadInput,
        fmt::format("the body of the request is nested deeper than the {} levels that are taken here",
                    kDeepestJson));
  return true;
}

/// Without a length there is no body, unless it comes in chunks.
bool has_body(const httplib::Request& request) {
  return request.has_header("Content-Length") || request.has_header("Transfer-Encoding");
}

}  // namespace

const std::string& Call::part(const std::string& name) const {
  for (const auto& [known, value] : parts_)
    if (known == name) return value;
  throw std::logic_error("no part " + name);
}

std::string Call::query(const std::string& name) const { return request_.get_param_value(name); }

double Call::query_number(const std::string& name) const {
  const std::string text = query(name);
  if (text.empty()) return std::nan("");
  double out = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (fault != std::errc() || end != text.data() + text.size() || !std::isfinite(out))
    throw bad_input(fmt::format("{} has to be a number, not '{}'", name, text));
  return out;
}

void Call::read_body(const Bytes& take) const {
  if (reader_ == nullptr || !has_body(request_)) return;
  const BodyRoom room(bodies_);
  const auto start = std::chrono::steady_clock::now();
  std::size_t bytes = 0;
  bool fits = true, in_time = true;
  const bool whole = (*reader_)([&](const char* data, std::size_t size) {
    bytes += size;
    fits = bytes <= most_bytes_;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    in_time = seconds < kPatience_s || static_cast<double>(bytes) >= kLeastBytesPer_s * seconds;
    return fits && in_time && take(data, size);
  });
  if (!fits) throw too_large(most_bytes_);
  if (!in_time)
    throw HttpError(Fault::kBadInput,
                    "the request came more slowly than 1 KB a second; send it again by a better connection");
  if (!whole) throw HttpError(Fault::kBadInput, "the request broke off before its end; send it again");
}

nlohmann::ordered_json Call::json() const {
  std::string body;
  read_body([&](const char* data, std::size_t size) {
    body.append(data, size);
    return true;
  });
  nlohmann::ordered_json out = nlohmann::ordered_json::parse(body, not_too_deep, false);
  if (out.is_discarded())
    throw HttpError(Fault::kBadInput, "the body of the request is no JSON; send an object in braces");
  if (!out.is_object())
    throw HttpError(Fault::kBadInput,
                    "the body of the request is JSON, but not an object; send an object in braces");
  return out;
}

void Router::add(Route route) { routes_.push_back(std::move(route)); }

Router::Match Router::find(std::string_view method, std::string_view path) const {
  for (const Route& route : routes_) {
    if (route.method != method) continue;
    if (auto parts = matched(route.pattern, path)) return {&route, std::move(*parts)};
  }
  return {};
}

std::vector<std::string> Router::methods_at(std::string_view path) const {
  std::vector<std::string> out;
  for (const Route& route : routes_)
    if (matched(route.pattern, path)) out.push_back(route.method);
  return out;
}

std::size_t Router::most_bytes(const httplib::Request& request) const {
  const Match match = find(method_of(request), request.path);
  return match.route == nullptr ? 0 : match.route->most_bytes;
}

void Router::serve(const httplib::Request& request, httplib::Response& response,
                   const httplib::ContentReader* reader) const {
  const auto fail = [&](Fault fault, const std::string& sentence) {
    answer_fault(response, status_of(fault), error_body(fault, sentence));
  };
  Match match = find(method_of(request), request.path);
  if (match.route == nullptr) {
    const std::vector<std::string> methods = methods_at(request.path);
    if (methods.empty()) return fail(Fault::kNotFound, "there is nothing at this address");
    fail(Fault::kBadInput, fmt::format("this address takes {} only", fmt::join(methods, ", ")));
    response.status = 405;
    response.set_header("Allow", fmt::format("{}", fmt::join(methods, ", ")));
    return;
  }
  Call call(request, reader, match.route->most_bytes);
  call.bodies_ = &bodies_;
  call.parts_ = std::move(match.parts);
  try {
    match.route->handler(call, response);
  } catch (...) {
    const Answer answer = answer_to(std::current_exception());
    fail(answer.fault, answer.sentence);
  }
  pack_body(request, response);
}

void answer(httplib::Response& response, const nlohmann::ordered_json& json, int status) {
  response.status = status;
  response.set_content(app::json_line(json), kJson);
}

void answer_fault(httplib::Response& response, int status, const std::string& body) {
  response.status = status;
  response.set_content(body, kJson);
}

}  // namespace tramline::server
