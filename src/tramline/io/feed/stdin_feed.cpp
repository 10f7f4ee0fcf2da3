#include <fcntl.h>
#include <unistd.h>

#include "tramline/io/feed/descriptor.h"
#include "tramline/io/feed/feed.h"
#include "tramline/io/feed/line_splitter.h"

namespace tramline::io {
namespace {

/// Is read only after a wait, so that it need not be made non-blocking: it may be shared with a shell.
class StdinFeed final : public Feed {
 public:
  std::string name() const override { return "stdin"; }
  int descriptor() const override { return stdin_.number(); }
  int wait_ms() const override { return -1; }

  Received receive() override {
    Received out;
    std::string bytes;
    int fault = 0;
    const ReadResult result = read_some(stdin_, bytes, fault);
    splitter_.add(bytes, out.lines);
    if (result == ReadResult::kFault) out.messages.push_back("stdin cannot be read: " + words_for(fault));
    out.ended = result == ReadResult::kEnd || result == ReadResult::kFault;
    return out;
  }
  std::string rest() override { return splitter_.take_rest(); }

 private:
  Descriptor stdin_{dup(STDIN_FILENO)};
  LineSplitter splitter_;
};

}  // namespace

std::unique_ptr<Feed> stdin_feed() { return std::make_unique<StdinFeed>(); }

}  // namespace tramline::io
