#include "options/plan_options.h"

#include <fmt/format.h>

#include "request/paper_conventions.h"
#include "request/plan_defaults.h"

namespace tramline::app {
namespace {

void add_avoidance_options(CommandOptions& command, PlanOptions& o) {
  command.begin_group("Obstacles");
  command
      .add_option("--avoid", o.avoid,
                  "What a track does at an obstacle. 'cut': it ends before the obstacle and begins again "
                  "behind it. 'paper': it goes round by the rule of Versleijen 2019, and is cut where that "
                  "rule allows no detour. 'cheapest': it takes whichever way past costs least.")
      .takes("WORD")
      .shows_default("cheapest");
  command
      .add_option("--avoid-threshold", o.avoid_threshold_m,
                  "With --avoid paper: tracks go round obstacles whose extent across the track is less than "
                  "this, in metres.")
      .takes("M")
      .shows_default("the working width");
  command
      .add_option("--avoid-room", o.avoid_room_m,
                  "With --avoid paper: the most by which a detour may leave its track, in metres; where it "
                  "would have to go farther the track is cut. The thesis' own program allowed half the "
                  "working width.")
      .takes("M")
      .shows_default("as far as it has to");
  command.add_option("--clearance", o.clearance_m, "Land kept free between swaths and obstacles, in metres.")
      .takes("M")
      .shows_default("0");
}

/// The default of an option where plans are to be driven, and where they are tracks alone.
std::string default_text(PlanDefaults defaults, const char* whole, const char* tracks) {
  return defaults == PlanDefaults::kTracks ? tracks : fmt::format("{}; for tracks alone {}", whole, tracks);
}

void add_headland_options(CommandOptions& command, PlanOptions& o, PlanDefaults defaults) {
  command.begin_group("Headlands and turns");
  command
      .add_option("--headlands", o.headlands,
                  "Number of passes round the field, outside the tracks; swaths then stay inside the field. "
                  "'auto': as many as the turns of this machine need, along those edges where tracks end.")
      .takes("N")
      .check(headlands_fault)
      .shows_default(default_text(defaults, "auto", "0"));
  command
      .add_option("--obstacle-headlands", o.obstacle_headlands,
                  "Number of passes round each obstacle that tracks do not go round. 'auto': as many as the "
                  "turns need, where they cost less than cuts and detours.")
      .takes("N")
      .check(headlands_fault)
      .shows_default(default_text(defaults, "auto", "0"));
  command.add_flag("--turns", o.turns,
                   "Plan the turn from each track to the next: the quickest manoeuvre that stays on the "
                   "land. Automatic headlands imply it.");
  command
      .add_option("--spacing", o.spacing,
                  "Which track is driven next: 'adjacent', the one beside it, or 'skip K', one at least K "
                  "tracks away, so that turns need less room.")
      .takes("WORD")
      .check(spacing_fault)
      .shows_default("adjacent");
  command
      .add_option("--turn-room", o.turn_room_m,
                  "How far beyond a soft boundary without headland the machine may turn, in metres.")
      .takes("M")
      .shows_default("as far as it needs");
  command
      .add_option("--towing-error", o.towing_error_m,
                  "Largest distance of a towed implement from its track where the work begins, in metres.")
      .takes("M")
      .shows_default("0.1");
}

void add_route_options(CommandOptions& command, PlanOptions& o, PlanDefaults defaults) {
  command.begin_group("Route");
  command
      .add_option("--route", o.route,
                  fmt::format("With 'whole', or without a value, plan the whole route: the order of tracks "
                              "and headland passes, and the way between each two of them. With 'none', do "
                              "not. Default: {}.",
                              default_text(defaults, "whole", "none")))
      .takes("WORD")
      .value_may_be_left_out();  // a default for --help to show would stand for the value left out
  command
      .add_option(
          "--order", o.order,
          "Which track the route takes next: 'best', in the order that takes the least time, 'adjacent', the "
          "one beside it, or 'skip K' as with --spacing.")
      .takes("WORD")
      .check(order_fault)
      .shows_default("best");
  command
      .add_option(
          "--headland-time", o.headland_time,
          "When the route works the headland passes: 'first', before all tracks, or 'last', after them; "
          "those round obstacles then also among them, behind the tracks that end there.")
      .takes("WORD")
      .shows_default("last");
  command
      .add_option(
          "--pass-sequence", o.pass_sequence,
          "In which sequence the route works the passes along one boundary: 'inwards', 'outwards', or 'any', "
          "whichever makes the way shortest.")
      .takes("WORD")
      .shows_default("any");
  command
      .add_option("--pass-corners", o.pass_corners,
                  "How headland passes take corners: 'round', or 'auto', straight on to the edge and out in "
                  "reverse where that costs less than the land left outside a round corner. Passes are round "
                  "where the plan is not to cost least as a whole.")
      .takes("WORD")
      .shows_default("auto");
  command
      .add_option("--start", o.start,
                  "Where the route starts: a point, \"x,y\", in the field's coordinates or in longitude and "
                  "latitude, or a file of points, of which the one nearest to the field counts.")
      .takes("POINT|FILE")
      .shows_default("at a track or a pass");
  command.add_option("--end", o.end, "Where the route ends, given like --start.")
      .takes("POINT|FILE")
      .shows_default("at a track or a pass");
}

void add_line_options(CommandOptions& command, PlanOptions& o, PlanDefaults defaults) {
  command.begin_group("Tracks along a line");
  Option ab = command.add_option("--ab", o.ab,
                                 "Straight tracks along the line through two points, \"x1,y1 x2,y2\", in the "
                                 "field's coordinates or in longitude and latitude.");
  Option guide =
      command.add_option("--guide", o.guide_file,
                         "Tracks along the line in this vector file: parallel curves where it has bends.");
  Option where =
      command.add_option("--guide-where", o.guide_where, "Which line of --guide, such as \"name='AB 1'\".");
  Option curved =
      command.add_option("--curved", o.curved,
                         "Curved tracks along edges of the field: 'auto' in those subfields where they cost "
                         "less than straight ones, 'always', or 'never'.");
  Option tracks = command.add_option("--tracks", o.tracks,
                                     "How tracks along a line are made: 'parallel' to the line and fit to be "
                                     "driven, or 'paper' (Zhou et al. "
                                     "2020), each from the one before with all its kinks, for comparison.");
  command
      .add_option(
          "--ab-anchor", o.ab_anchor,
          "Where straight tracks along --ab or --guide begin: 'line', which is the border of the first "
          "swath, or 'envelope' (Zhou et al. 2020), with the first swath along the edge of the land, on "
          "the left of the line.")
      .takes("WORD")
      .shows_default("line; envelope with --tracks paper");
  ab.takes("POINTS").shows_default("none").excludes(guide).excludes(curved);
  guide.takes("FILE").shows_default("none").excludes(curved);
  where.takes("FILTER").shows_default("the only line").needs(guide);
  curved.takes("WORD").shows_default(default_text(defaults, "auto", "never"));
  tracks.takes("WORD").shows_default("parallel");
}

void add_search_options(CommandOptions& command, PlanOptions& o) {
  command.begin_group("Search");
  command
      .add_option("--strategy", o.strategy,
                  "'best' of all directions, offsets and divisions of the field, or 'sweep', the search of "
                  "Versleijen 2019 over the directions of the field's edges.")
      .takes("WORD")
      .shows_default("best");
  command
      .add_option("--direction-tolerance", o.direction_tolerance_deg,
                  "With --strategy best: directions nearer to one another than this count as one, in "
                  "degrees.")
      .takes("DEG")
      .shows_default("0.01");
  command.add_flag("--prove", o.prove,
                   "Prove how cheap no plan is by prices of the land, which check verifies: takes seconds to "
                   "minutes. With --strategy best, straight tracks and --route none, on fields without "
                   "obstacles.");
  command
      .add_option("--decomposition", o.decomposition_deg,
                  "Split the field at corners whose inside angle is larger than this, in degrees.")
      .takes("DEG")
      .shows_default("180");
  command
      .add_option("--short-edge", o.short_edge_m,
                  "Do not split at corners between two edges that are both shorter than this, in metres.")
      .takes("M")
      .shows_default("0");
  command
      .add_option("--merge", o.merge_deg,
                  "Merge subfields whose directions differ by no more than this, in degrees.")
      .takes("DEG")
      .shows_default("1");
  command
      .add_option("--cell-direction", o.cell_direction,
                  "Direction of a cell's tracks: 'rectangle', along the long side of its smallest bounding "
                  "rectangle, or 'width', at right angles to its least width.")
      .takes("WORD")
      .shows_default("rectangle");
}

}  // namespace

void add_machine_options(CommandOptions& command, PlanOptions& o, const char* least_length) {
  command.begin_group("Machine");
  command.add_option("--width", o.width_m, "Working width in metres.").takes("M").shows_default("3");
  command.add_option("--radius", o.radius_m, "Least turning radius in metres.").takes("M").shows_default("6");
  command.add_option("--machine", o.machine_file, "Machine file (TOML); options take precedence over it.")
      .takes("FILE")
      .shows_default("none");
  command.add_option("--min-length", o.min_length_m, "Shortest piece of a track worth driving, in metres.")
      .takes("M")
      .shows_default(least_length);
}

void add_turning_options(CommandOptions& command, TurningOptions& o) {
  const Turning usual;
  const auto add = [&](double Turning::*value, const char* unit, const char* help) {
    for (std::size_t i = 0; i < kTurningNumbers.size(); ++i)
      if (kTurningNumbers[i].value == value)
        command.add_option(option_of(kTurningNumbers[i]), o.numbers[i], help)
            .takes(unit)
            .shows_default(fmt::format("{:g}", usual.*value));
  };
  command.begin_group("Turning");
  command.add_flag("--reverse", o.reverse, "The machine may reverse when it turns.");
  add(&Turning::working_speed_mps, "M/S", "Speed at work, in metres per second.");
  add(&Turning::turning_speed_mps, "M/S", "Speed forward when turning, in metres per second.");
  add(&Turning::reverse_speed_mps, "M/S", "Speed in reverse, in metres per second.");
  add(&Turning::gear_change_s, "S", "Time to stop and start in the other gear, in seconds.");
  add(&Turning::steering_time_s, "S",
      "Time to steer from straight ahead to the smallest circle, in seconds.");
  add(&Turning::lift_m, "M", "Distance driven straight on after the work ends, in metres.");
  add(&Turning::lower_m, "M", "Distance driven straight before the work begins, in metres.");
  command.begin_group("Vehicle and implement");
  command
      .add_option(
          "--implement", o.implement,
          "How the implement is coupled: 'mounted', so that it turns with the vehicle, or 'towed', so that "
          "it follows on a drawbar.")
      .takes("WORD")
      .shows_default("mounted");
  add(&Turning::implement_offset_m, "M",
      "Distance from the rear axle back to the line where a mounted implement works, or to the hitch of a "
      "towed one, in metres; negative for an implement in front of the axle.");
  add(&Turning::drawbar_m, "M",
      "With --implement towed: distance from the hitch to the axle of the implement, where it works, in "
      "metres.");
  add(&Turning::front_overhang_m, "M", "How far the vehicle reaches ahead of its rear axle, in metres.");
  add(&Turning::rear_overhang_m, "M",
      "How far the implement reaches behind the line where it works, in metres.");
  add(&Turning::vehicle_width_m, "M", "Width of the vehicle, in metres.");
}

void add_rate_options(CommandOptions& command, RateOptions& o) {
  const auto add = [&](double Rates::*value, const char* unit, const char* help, const char* usual) {
    for (std::size_t i = 0; i < kRateNumbers.size(); ++i)
      if (kRateNumbers[i].value == value)
        command.add_option(option_of(kRateNumbers[i]), o.numbers[i], help).takes(unit).shows_default(usual);
  };
  const char* const usual = "as usual for the operation";
  command.begin_group("Prices of the whole route");
  command
      .add_option("--operation", o.operation,
                  fmt::format("What the machine does: {}. It decides the usual prices, and the speed at work "
                              "where --working-speed is not given.",
                              operation_words()))
      .takes("WORD")
      .shows_default("general");
  add(&Rates::price_per_hour, "€", "Machine and driver per hour, without fuel, in euros.", usual);
  add(&Rates::fuel_l_per_h, "L", "Fuel at work, in litres per hour; with the work off half of it counts.",
      usual);
  add(&Rates::fuel_price, "€", "Fuel, in euros per litre.", "1.2");
  add(&Rates::sections, "N",
      "Sections of the implement that switch off by themselves over worked land: overlap takes an N-th of "
      "the input.",
      "1");
  add(&Rates::input_price_per_ha, "€",
      "Seed, spray or fertiliser, in euros per hectare: land worked twice gets it twice.", usual);
  add(&Rates::margin_per_ha, "€", "What a hectare left unworked loses, in euros.", usual);
  add(&Rates::price_per_stop, "€",
      "What it costs, besides time, to back out of an end that has no way off, in euros.", "1");
}

void add_objective_options(CommandOptions& command, PlanOptions& o, PlanDefaults defaults) {
  command.begin_group("Objective");
  const char* const prices_text =
      defaults == PlanDefaults::kTracks ? "the prices" : "the prices of the whole route";
  Option weights = command.add_option("--weights", o.weights,
                                      "Weights of overlap (1/m²), uncovered land (1/m²), turns[, stops[, "
                                      "further subfields]]; those left out are 0.");
  Option prices =
      command.add_option("--prices", o.prices,
                         "Prices of overlap (€/m²), uncovered land (€/m²), turns (€)[, stops (€)[, "
                         "further subfields (€)]].");
  Option minimise = command.add_option(
      "--minimise", o.minimise,
      "What to minimise before all else: 'overlap', 'uncovered' or 'turns'. It gets the weight 99999, the "
      "other two the weight 1.");
  weights.takes("NUMBERS").shows_default(prices_text).excludes(prices).excludes(minimise);
  prices.takes("NUMBERS")
      .shows_default(defaults == PlanDefaults::kTracks ? "0.02,0.10,1,5,5" : prices_text)
      .excludes(minimise);
  minimise.takes("WORD").shows_default(prices_text);
}

void add_land_options(CommandOptions& command, LandOptions& o) {
  command.begin_group("Land");
  command
      .add_option(
          "--subfields", o.subfields_file,
          "Subfields drawn by hand, in a vector file: polygons, with the columns direction_deg (of the "
          "tracks, degrees clockwise from north), guide (the name of a line in the file that they follow) "
          "and skip (yes: land left out), all of which may be missing; and lines to cut the rest along. "
          "All may run over the edge of the field.")
      .takes("FILE")
      .shows_default("the field is divided where that pays");
  command
      .add_option("--only", o.only_file,
                  "Plan only the land inside the polygons of this file. The rest is not to be worked.")
      .takes("FILE")
      .shows_default("the whole field");
  command
      .add_option(
          "--done", o.done_files,
          "Plan only what has not been done yet. This file says what has: a plan file, whose swaths count as "
          "done, a coverage file of 'tramline evaluate', or polygons. May be given several times.")
      .takes("FILE")
      .shows_default("nothing is done")
      .one_value_each_time();
}

void take_conventions(const CommandOptions& command, PlanOptions& o) {
  const auto given = [&command](const std::string& option) {
    if (option != "--minimise") return command.is_given(option);
    return command.is_given(option) || command.is_given("--weights") || command.is_given("--prices");
  };
  for (const Convention& convention : conventions_like(o.like))
    if (!given(convention.option)) convention.take(o);
}

void take_whole_plan(const CommandOptions& command, PlanOptions& o) {
  if (asks_for_tracks(o)) return;
  for (const Convention& convention : whole_plan_defaults(o))
    if (!command.is_given(convention.option)) convention.take(o);
}

void add_plan_options(CommandOptions& command, PlanOptions& o, PlanDefaults defaults) {
  command.begin_group("Conventions");
  command
      .add_option("--like", o.like,
                  fmt::format("Plan as a paper does: options that are not given are those of 'versleijen' "
                              "(Versleijen 2019): {}; or of 'zhou' (Zhou et al. 2020): {}.",
                              conventions_text("versleijen"), conventions_text("zhou")))
      .takes("WORD")
      .shows_default("the program's own");
  add_machine_options(command, o, "twice the working width");
  add_turning_options(command, o.turning);
  add_rate_options(command, o.rates);
  add_objective_options(command, o, defaults);
  add_search_options(command, o);
  command.begin_group("Swaths");
  command
      .add_option("--end-rule", o.end_rule,
                  "Where a swath ends at a soft edge that crosses it obliquely: 'cheapest' (where continuing "
                  "no longer pays), 'centre' (where the centre line meets the edge), 'cover' (nothing is "
                  "missed) or 'inside' (nothing is overlapped).")
      .takes("WORD")
      .shows_default("cheapest");
  command
      .add_option("--boundary", o.boundary,
                  "The field's outer edge: 'soft', swaths may run past it, or 'hard', they end inside it.")
      .takes("WORD")
      .shows_default(default_text(defaults, "hard", "soft"));
  add_avoidance_options(command, o);
  add_headland_options(command, o, defaults);
  add_route_options(command, o, defaults);
  add_line_options(command, o, defaults);
}

}  // namespace tramline::app
