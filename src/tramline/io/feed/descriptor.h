#pragma once
// A file descriptor that closes itself.

#include <string>
#include <utility>

namespace tramline::io {

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor() { reset(); }

  /// -1: none.
  int number() const { return number_; }
  bool open() const { return number_ >= 0; }
  void reset();

 private:
  int number_ = -1;
};

/// What is lost is opened again so often, ms.
inline constexpr int kAgain_ms = 1000;

/// The result of one non-blocking read of a descriptor.
enum class ReadResult { kBytes, kNothingYet, kEnd, kFault };

/// Appends the available bytes, 64 KiB at most. `fault`: the errno of kFault.
ReadResult read_some(const Descriptor& descriptor, std::string& bytes, int& fault);

/// The words for an errno: "Connection refused".
std::string words_for(int fault);

}  // namespace tramline::io
