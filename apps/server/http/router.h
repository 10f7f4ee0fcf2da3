#pragma once
// Dispatches requests to handlers.

#include <httplib.h>

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <semaphore>
#include <string>
#include <string_view>
#include <vector>

namespace tramline::server {

/// The largest body that is not an upload.
inline constexpr std::size_t kMostJsonBytes = std::size_t{4} << 20;

/// The deepest nesting of lists and objects in the JSON of a body.
inline constexpr int kDeepestJson = 32;

/// The number of bodies received at once. More are refused, so that some threads never wait for a sender.
inline constexpr std::ptrdiff_t kMostBodies = 64;
/// A body that comes more slowly is refused once kPatience_s have passed.
inline constexpr double kLeastBytesPer_s = 1024, kPatience_s = 20;

/// A request on its way to its handler.
class Call {
 public:
  using Bytes = std::function<bool(const char*, std::size_t)>;

  Call(const httplib::Request& request, const httplib::ContentReader* reader, std::size_t most_bytes)
      : request_(request), reader_(reader), most_bytes_(most_bytes) {}

  const httplib::Request& request() const { return request_; }
  /// The part of the path for {name}.
  const std::string& part(const std::string& name) const;
  /// "?name=value"; empty where it is not there.
  std::string query(const std::string& name) const;
  /// "?from_s=12.5"; NaN where it is not there. Throws bad_input where it is no finite number.
  double query_number(const std::string& name) const;

  /// Hands on the body as it comes in; once. Throws HttpError(kTooLarge) where it grows beyond the route's
  /// limit, kBadInput where it breaks off or comes more slowly than kLeastBytesPer_s, and kBusy where
  /// kMostBodies are being received already.
  void read_body(const Bytes& take) const;
  /// The body as JSON, an object. Throws HttpError(kBadInput) for anything else, and for JSON that is
  /// nested deeper than kDeepestJson, and like read_body().
  nlohmann::ordered_json json() const;

 private:
  friend class Router;
  const httplib::Request& request_;
  const httplib::ContentReader* reader_;
  std::size_t most_bytes_;
  std::counting_semaphore<kMostBodies>* bodies_ = nullptr;  ///< of the router; none: no limit
  std::vector<std::pair<std::string, std::string>> parts_;
};

using Handler = std::function<void(const Call&, httplib::Response&)>;

struct Route {
  std::string method;   ///< GET, POST, PUT, PATCH or DELETE
  std::string pattern;  ///< "/api/v1/fields/{field}"; a part in braces stands for one id
  Handler handler;
  std::size_t most_bytes = kMostJsonBytes;  ///< of the body
};

/// All routes, and the way from a request to one of them. An id is [a-z0-9-]{1,64}, another word that stands
/// for a part in braces [A-Za-z0-9_.-]{1,64}; anything else is not found, so that no part of a path of a
/// request is ever more than a name.
class Router {
 public:
  void get(const std::string& pattern, Handler handler) { add({"GET", pattern, std::move(handler)}); }
  void post(const std::string& pattern, Handler handler) { add({"POST", pattern, std::move(handler)}); }
  void put(const std::string& pattern, Handler handler) { add({"PUT", pattern, std::move(handler)}); }
  void patch(const std::string& pattern, Handler handler) { add({"PATCH", pattern, std::move(handler)}); }
  /// Named so because `delete` is a word of the language.
  void remove(const std::string& pattern, Handler handler) { add({"DELETE", pattern, std::move(handler)}); }
  void add(Route route);

  const std::vector<Route>& routes() const { return routes_; }

  /// How long the body of this request may be; 0 where no route takes it.
  std::size_t most_bytes(const httplib::Request& request) const;

  /// Finds the route and calls its handler; failures of any kind become answers. `reader`: nullptr for
  /// methods without a body.
  void serve(const httplib::Request& request, httplib::Response& response,
             const httplib::ContentReader* reader) const;

 private:
  struct Match {
    const Route* route = nullptr;
    std::vector<std::pair<std::string, std::string>> parts;
  };
  Match find(std::string_view method, std::string_view path) const;
  std::vector<std::string> methods_at(std::string_view path) const;

  std::vector<Route> routes_;
  mutable std::counting_semaphore<kMostBodies> bodies_{kMostBodies};
};

/// An answer in JSON.
void answer(httplib::Response& response, const nlohmann::ordered_json& json, int status = 200);
/// An error as the API words it.
void answer_fault(httplib::Response& response, int status, const std::string& body);

}  // namespace tramline::server
