#include "tramline/io/feed/descriptor.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace tramline::io {

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  if (this != &other) {
    reset();
    number_ = std::exchange(other.number_, -1);
  }
  return *this;
}

void Descriptor::reset() {
  if (number_ >= 0) close(number_);
  number_ = -1;
}

ReadResult read_some(const Descriptor& descriptor, std::string& bytes, int& fault) {
  std::array<char, 1 << 16> buffer;
  const ssize_t got = read(descriptor.number(), buffer.data(), buffer.size());
  if (got > 0) {
    bytes.append(buffer.data(), static_cast<std::size_t>(got));
    return ReadResult::kBytes;
  }
  if (got == 0) return ReadResult::kEnd;
  if (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR) return ReadResult::kNothingYet;
  fault = errno;
  return ReadResult::kFault;
}

std::string words_for(int fault) { return std::generic_category().message(fault); }

}  // namespace tramline::io
