// tramline watch: the evaluation of a drive while it goes on.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands/command.h"
#include "commands/watch_run.h"
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

constexpr const char* kHelp =
    "Watch a drive while it goes on: which ground is covered, worked again and missed, after every fix";
constexpr const char* kExample =
    "Example:\n"
    "  tramline watch --gpsd --field fields.gpkg --where \"id='mill-field'\" --width 24 -o today.gpkg\n"
    "  tramline watch --tcp tractor.local:5017 --width 6 --json\n"
    "  tramline watch --serial /dev/ttyUSB0,38400 --width 6 -o today.gpkg\n"
    "  tramline watch --follow drive.csv --field mill-field.geojson\n"
    "  tramline watch --udp 4001 --field fields.gpkg --width 24 --look-ahead --on-latency 0.6 --json\n"
    "The lines are CSV or NMEA, as their first ones tell; without a source they come from stdin. On a "
    "terminal "
    "the space key switches work on and off. With -o the lines go to today.gpkg.log, too, and a watch that "
    "was "
    "interrupted goes on from there. See docs/watch.md.";

class WatchCommand : public Command {
 public:
  Verb setup(CLI::App& program) override {
    Verb verb(program, "watch", kHelp);
    verb.add_option("--follow", follow_, "a file that is being written");
    verb.add_option("--tcp", tcp_, "HOST:PORT of a server that sends the lines");
    verb.add_option("--udp", udp_, "port that the lines are sent to").in_range(1, 65535);
    verb.add_option("--serial", serial_, "serial device and speed: /dev/ttyUSB0,38400 (115200 unless told)");
    verb.add_option("--gpsd", gpsd_, "HOST or HOST:PORT of gpsd (localhost:2947 unless told)")
        .value_may_be_left_out();
    verb.add_flag("--once", once_, "a connection that is lost is the end, and is not made again");
    add_field_choice(verb, field_);
    add_drive_options(verb, drive_);
    verb.add_option("-o,--output", output_.file,
                    "write the coverage to this GeoPackage (.gpkg), and the lines beside it (.gpkg.log)");
    verb.add_option("--save-every", output_.save_every_s, "write it so often, s, besides at the end")
        .in_range(1.0, 86400.0)
        .shows_default();
    add_look_ahead_options(verb);
    verb.add_option("--threads", threads_, "threads to use (default: all cores)").in_range(0, 1024);
    verb.add_flag("--json", output_.json, "print one JSON object a second");
    verb.add_flag("--quiet", output_.quiet, "no status, no table");
    verb.footer(kExample);
    verb_ = verb;
    return verb;
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
  void add_look_ahead_options(Verb& verb) {
    verb.add_flag("--look-ahead", look_ahead_,
                  "also say what each section comes to at present speed and heading, and when to switch it");
    verb.add_option("--horizon", rule_.horizon_s, "how far to look ahead, s")
        .in_range(0.1, 60.0)
        .shows_default();
    verb.add_option("--on-latency", rule_.on_latency_s, "from the command to the work of a section, s")
        .in_range(0.0, 30.0)
        .shows_default();
    verb.add_option("--off-latency", rule_.off_latency_s, "from the command to the end of its work, s")
        .in_range(0.0, 30.0)
        .shows_default();
    verb.add_option("--on-from", rule_.on_from,
                    "a section goes on where at least this share of its width needs work")
        .in_range(0.0, 1.0)
        .shows_default();
    verb.add_option("--off-below", rule_.off_below, "and off where less than this share does")
        .in_range(0.0, 1.0)
        .shows_default();
  }

  bool gpsd_asked() const { return verb_->is_given("--gpsd"); }
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
          "the lines come from one place: give one of --follow, --tcp, --udp, --serial and --gpsd");
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

  std::optional<Verb> verb_;
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
