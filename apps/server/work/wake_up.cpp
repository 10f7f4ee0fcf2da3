#include "server/work/wake_up.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include "tramline/geometry/error.h"

namespace tramline::server {

WakeUp::WakeUp() : descriptor_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (descriptor_ < 0) throw failure("the system gives no more file descriptors: close some programs");
}

WakeUp::~WakeUp() { close(descriptor_); }

void WakeUp::ring() { eventfd_write(descriptor_, 1); }

}  // namespace tramline::server
