// tramline watch: the evaluation of a drive while it goes on.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands/command.h"
#include "commands/watch_run.h"
#include "options/common_options.h"
#include "options/drive_options.h"
#include "options/field_options.h"
#include "output/output_target.h"
#include "request/evaluate_input.h"
#include "request/watch_session.h"
#include "tramline/coverage/thread_limit.h"
#include "tramline/geometry/error.h"
#include "tramline/io/feed/feed.h"
#include "tramline/io/feed/raw_log.h"

namespace tramline::app {
namespace {

constexpr const char* kWatchHelp =
    "Watch a drive while it goes on: which land is covered, repeated and missed, after every fix.";
constexpr const char* kWatchExample =
    "Examples:\n"
    "  tramline watch --gpsd --field fields.gpkg --where \"id='mill-field'\" --width 24 -o today.gpkg\n"
    "  tramline watch --tcp tractor.local:5017 --width 6 --json\n"
    "  tramline watch --serial /dev/ttyUSB0,38400 --width 6 -o today.gpkg\n"
    "  tramline watch --follow drive.csv --field mill-field.geojson\n"
    "  tramline watch --follow drive.csv --engine mesh --mesh 0.02\n"
    "  tramline watch --udp 4001 --field fields.gpkg --width 24 --look-ahead --on-latency 0.6 --json\n"
    "The lines are CSV or NMEA, recognised from the first ones. On a terminal the space key switches the "
    "work on\n"
    "and off. With -o the lines also go to today.gpkg.log, and a watch that was interrupted continues from "
    "there.\n"
    "docs/watch.md says more.";

class WatchCommand : public Command {
 public:
  CommandOptions setup(CLI::App& program) override {
    CommandOptions command(program, "watch", kWatchHelp);
    command.begin_group("Source of the lines");
    command.add_option("--follow", follow_, "A file that is being written.")
        .takes("FILE")
        .shows_default("stdin");
    command.add_option("--tcp", tcp_, "HOST:PORT of a server that sends the lines.")
        .takes("ADDRESS")
        .shows_default("stdin");
    command.add_option("--udp", udp_, "Port that the lines are sent to.")
        .takes("PORT")
        .in_range(1, 65535)
        .shows_default("stdin");
    command
        .add_option("--serial", serial_,
                    "Serial device and speed, such as /dev/ttyUSB0,38400 (default speed 115200).")
        .takes("DEVICE")
        .shows_default("stdin");
    command.add_option("--gpsd", gpsd_, "gpsd at HOST or HOST:PORT; without a value at localhost:2947.")
        .takes("[ADDRESS]")
        .value_may_be_left_out();
    command.add_flag("--once", once_, "Stop when a connection is lost instead of connecting again.");
    add_field_choice(command, field_);
    add_drive_options(command, drive_);
    add_look_ahead_options(command);
    command.begin_group("Output");
    add_output_option(command, output_.file,
                      "Write the coverage to this GeoPackage (.gpkg), and the lines beside it (.gpkg.log).");
    command
        .add_option("--save-every", output_.save_every_s,
                    "Interval at which the coverage is written, in seconds; it is also written at the end.")
        .takes("S")
        .in_range(1.0, 86400.0)
        .shows_default();
    command.add_flag("--json", output_.json, "Print one JSON object a second.");
    command.add_flag("--quiet", output_.quiet, "Print neither status nor table.");
    command.begin_group("Run");
    add_threads_option(command, threads_);
    command.footer(kWatchExample);
    command_ = command;
    return command;
  }

  int run() override {
    require_one_source();
    const std::string raw_log = output_.file.empty() ? "" : output_.file + ".log";
    require_writable(output_.file, "--output", {".gpkg"}, {field_.file, follow_});
    require_writable(raw_log, "--output", {".log"}, {field_.file, follow_});
    coverage::EvaluateSettings settings;
    apply(drive_, settings);
    settings.shapes = !output_.file.empty();
    if (look_ahead_) {
      require_sensible(rule_);
      if (settings.engine != coverage::EngineKind::kExact)
        throw bad_input("--look-ahead needs --engine exact");
      output_.look_ahead = rule_;
    }
    const coverage::ThreadLimit limit(threads_);
    const EndSignals signals;
    WorkGround ground;
    if (std::optional<WorkGround> field = work_ground(field_)) ground = std::move(*field);
    const std::unique_ptr<io::Feed> feed = source();
    std::unique_ptr<io::RawLog> log;
    if (!raw_log.empty()) log = std::make_unique<io::RawLog>(raw_log);
    WatchSession session(std::move(ground), settings, drive_.log, feed->name());
    WatchRun watch(session, *feed, log.get(), output_, line_source());
    return watch.run(signals);
  }

 private:
  void add_look_ahead_options(CommandOptions& command) {
    command.begin_group("Sections ahead");
    command.add_flag(
        "--look-ahead", look_ahead_,
        "Also report whether the land ahead of each section, at the present speed and heading, needs work, "
        "and when to switch the section.");
    command.add_option("--horizon", rule_.horizon_s, "How far to look ahead, in seconds.")
        .takes("S")
        .in_range(0.1, 60.0)
        .shows_default();
    command
        .add_option("--on-latency", rule_.on_latency_s,
                    "Time from the command to switch a section on until it works, in seconds.")
        .takes("S")
        .in_range(0.0, 30.0)
        .shows_default();
    command
        .add_option("--off-latency", rule_.off_latency_s,
                    "Time from the command to switch a section off until it stops working, in seconds.")
        .takes("S")
        .in_range(0.0, 30.0)
        .shows_default();
    command
        .add_option("--on-from", rule_.on_from,
                    "Switch a section on where at least this share of its width needs work.")
        .takes("SHARE")
        .in_range(0.0, 1.0)
        .shows_default();
    command
        .add_option("--off-below", rule_.off_below,
                    "Switch a section off where less than this share of its width needs work.")
        .takes("SHARE")
        .in_range(0.0, 1.0)
        .shows_default();
  }

  bool gpsd_asked() const { return command_->is_given("--gpsd"); }
  int sources() const {
    return static_cast<int>(!follow_.empty()) + static_cast<int>(!tcp_.empty()) +
           static_cast<int>(udp_ != 0) + static_cast<int>(!serial_.empty()) + static_cast<int>(gpsd_asked());
  }
  bool from_stdin() const { return sources() == 0; }
  LineSource line_source() const {
    if (!follow_.empty()) return LineSource::kFollowedFile;
    return from_stdin() ? LineSource::kStdin : LineSource::kDevice;
  }

  void require_one_source() const {
    if (sources() > 1)
      throw bad_input(
          "lines are read from one source only: give one of --follow, --tcp, --udp, --serial and --gpsd");
  }

  std::unique_ptr<io::Feed> source() const {
    const io::WhenLost lost = once_ ? io::WhenLost::kEnd : io::WhenLost::kReopen;
    if (!follow_.empty()) return io::file_feed(follow_);
    if (!tcp_.empty()) return io::tcp_feed(tcp_, lost);
    if (udp_ != 0) return io::udp_feed(udp_);
    if (!serial_.empty()) return io::serial_feed(serial_, lost);
    if (gpsd_asked()) return io::gpsd_feed(gpsd_, lost);
    return io::stdin_feed();
  }

  std::optional<CommandOptions> command_;
  FieldOptions field_;
  DriveOptions drive_;
  WatchOutput output_;
  std::string follow_, tcp_, serial_, gpsd_;
  int udp_ = 0, threads_ = 0;
  bool once_ = false, look_ahead_ = false;
  coverage::SwitchRule rule_;
};

}  // namespace

std::unique_ptr<Command> make_watch_command() { return std::make_unique<WatchCommand>(); }

}  // namespace tramline::app
