// tramline serve, in a program that was built without its server.

#include "commands/command.h"
#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

class NoServeCommand : public Command {
 public:
  CommandOptions setup(CLI::App& program) override {
    CommandOptions command(program, "serve", "Serve a web page; this program was built without it.");
    // Whatever follows, the answer is the same.
    command.takes_anything();
    return command;
  }

  int run() override {
    throw failure(
        "this program was built without the page and its server: run 'make' in tramline's folder, or "
        "configure with -DTRAMLINE_SERVER=ON, and build it again");
  }
};

}  // namespace

std::unique_ptr<Command> make_serve_command() { return std::make_unique<NoServeCommand>(); }

}  // namespace tramline::app
