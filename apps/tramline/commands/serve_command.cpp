// tramline serve: the page, and the API behind it.

#include <fmt/format.h>
#include <pthread.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "commands/command.h"
#include "server/http/gate.h"
#include "server/server.h"
#include "server/store/new_id.h"
#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

constexpr const char* kServeAbout =
    "Serve a web page on which to plan, compare and replay, to the browsers of this computer.";

constexpr const char* kServeExample =
    "Examples:\n"
    "  tramline serve\n"
    "  tramline serve farm --port 9000\n"
    "  tramline serve --feed-dir /srv/drives\n"
    "  tramline serve --background orthophoto.mbtiles\n"
    "  tramline serve --host 0.0.0.0 --tiles \"https://tile.example.org/{z}/{x}/{y}.png\"\n"
    "DIR keeps fields, machines, plans and drives as GeoPackages. Nothing leaves this computer unless --host "
    "or\n"
    "--tiles is given. With --host, browsers on other computers need the token in the address that is "
    "printed.";

/// Ends the server at SIGINT or SIGTERM. The signals have to be blocked in all threads.
class StopAtSignal {
 public:
  StopAtSignal(server::Server& server, const sigset_t& signals)
      : thread_([this, &server, signals] {
          using namespace std::chrono_literals;
          const timespec while_waiting{0, 200'000'000};
          while (!over_ && sigtimedwait(&signals, nullptr, &while_waiting) < 0) {
          }
          // A server that is only just starting is not yet there to be stopped.
          for (; !over_; std::this_thread::sleep_for(20ms)) server.stop();
        }) {}
  ~StopAtSignal() {
    over_ = true;
    thread_.join();
  }
  StopAtSignal(const StopAtSignal&) = delete;
  StopAtSignal& operator=(const StopAtSignal&) = delete;

 private:
  std::atomic<bool> over_ = false;
  std::thread thread_;
};

class ServeCommand : public Command {
 public:
  CommandOptions setup(CLI::App& program) override {
    CommandOptions command(program, "serve", kServeAbout);
    command.footer(kServeExample);
    command.add_option("DIR", folder_, "Folder that keeps everything, made if it is missing.")
        .shows_default("~/.local/share/tramline");
    command.begin_group("Network");
    command.add_option("--port", settings_.port, "Port to listen on; 0 for any free one.")
        .takes("PORT")
        .in_range(0, 65535)
        .shows_default("8750");
    command
        .add_option("--host", settings_.host,
                    "Address to listen on. With any other than the default, browsers need the token.")
        .takes("ADDRESS")
        .shows_default("127.0.0.1, this computer only");
    command.add_option("--token", settings_.token, "The token that browsers need.")
        .takes("TEXT")
        .shows_default("made at random where --host asks for one");
    command.begin_group("Map");
    command
        .add_option("--tiles", settings_.tiles,
                    "URL of raster tiles to show under the map, with {z}, {x} and {y}.")
        .takes("URL")
        .shows_default("none, and no network access");
    command
        .add_option("--background", background_,
                    "Picture of the land to show under the map, from this computer: MBTiles, GeoTIFF, or the "
                    "raster of a GeoPackage.")
        .takes("FILE")
        .shows_default("none");
    command
        .add_option("--tiles-attribution", settings_.tiles_attribution,
                    "Source of the tiles or of the picture, shown on the map.")
        .takes("TEXT")
        .shows_default("the host of the URL, or the name of the file");
    command.begin_group("Live drives");
    command
        .add_option(
            "--feed-dir", feed_folders_,
            "Folder whose files live feeds may read (file:///...), besides DIR. May be given several times.")
        .takes("FOLDER")
        .one_value_each_time()
        .shows_default("DIR only");
    command.begin_group("Run");
    command.add_option("--threads", threads_, "Accepted by every command; here each plan uses all cores.")
        .takes("N")
        .in_range(0, 1024)
        .shows_default("all cores");
    command.add_flag("--quiet", quiet_, "Print nothing but errors.");
    return command;
  }

  int run() override {
    require_sensible();
    settings_.background = background_;
    settings_.feed_folders.assign(feed_folders_.begin(), feed_folders_.end());
    settings_.folder = folder_.empty() ? server::default_folder() : std::filesystem::path(folder_);
    if (settings_.token.empty() && !server::is_loopback(settings_.host))
      settings_.token = server::new_token();
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    // A file that grows beyond `ulimit -f` is a full disk, and not the end.
    std::signal(SIGXFSZ, SIG_IGN);
    server::Server server(settings_);
    for (const std::string& warning : server.warnings())
      fmt::print(stderr, "tramline: left aside: {}\n", warning);
    if (!quiet_) announce(server);
    const StopAtSignal stop(server, signals);
    server.run();
    return 0;
  }

 private:
  void require_sensible() const {
    constexpr std::size_t kShortest = 8;
    if (!settings_.token.empty() &&
        (settings_.token.size() < kShortest ||
         settings_.token.find_first_not_of(
             "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ-_") != std::string::npos))
      throw bad_input("--token takes at least 8 letters, digits, '-' or '_'");
    const bool web = settings_.tiles.starts_with("http://") || settings_.tiles.starts_with("https://");
    if (!settings_.tiles.empty() && !web)
      throw bad_input(
          fmt::format("--tiles takes a URL that begins with https:// or http://, not '{}'", settings_.tiles));
    const auto has = [&](const char* part) { return settings_.tiles.find(part) != std::string::npos; };
    if (web && !(has("{z}") && has("{x}") && has("{y}")))
      throw bad_input(fmt::format(
          "--tiles takes a URL with {{z}}, {{x}} and {{y}} where the numbers of a tile belong, not '{}'",
          settings_.tiles));
    const bool background = !background_.empty();
    if (background && !settings_.tiles.empty())
      throw bad_input("the map has one background: give --tiles or --background, not both");
    if (settings_.tiles.empty() && !background && !settings_.tiles_attribution.empty())
      throw bad_input(
          "--tiles-attribution names the source of tiles; give the tiles with --tiles or --background, too");
  }

  void announce(const server::Server& server) const {
    const char* word = "tramline serves ";
    for (const std::string& address : server.addresses()) {
      fmt::print("{}{}\n", word, address);
      word = "             or ";
    }
    fmt::print("and keeps everything in {}. Press Ctrl-C to end it.\n", settings_.folder.string());
    std::fflush(stdout);
  }

  server::ServerSettings settings_{.folder = {},
                                   .host = "127.0.0.1",
                                   .port = 8750,
                                   .token = {},
                                   .tiles = {},
                                   .tiles_attribution = {},
                                   .background = {},
                                   .feed_folders = {},
                                   .limits = {}};
  std::string folder_, background_;
  std::vector<std::string> feed_folders_;
  int threads_ = 0;
  bool quiet_ = false;
};

}  // namespace

std::unique_ptr<Command> make_serve_command() { return std::make_unique<ServeCommand>(); }

}  // namespace tramline::app
