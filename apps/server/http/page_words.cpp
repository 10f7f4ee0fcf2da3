#include "server/http/page_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

namespace tramline::server {
namespace {

/// Whole phrases first, then the options by themselves.
constexpr std::array<std::pair<std::string_view, std::string_view>, 70> kWords = {{
    {"take all with --all or choose one with --id", "choose one of them"},
    {"give it a width with --width", "give the working width"},
    {"give the field's CRS with --crs", "say which coordinate reference system the field is in"},
    {"give the right CRS with --crs", "choose the right coordinate reference system"},
    {"with --tracks paper give --ab, --guide or --curved", "draw a line or choose curved tracks"},
    {"give a line with --guide, or leave --curved out", "draw a line to follow, or choose straight tracks"},
    {"give one with --guide, or leave --tracks paper out", "draw one, or choose tracks parallel to the line"},
    {"leave --curved out, or give a line without bends",
     "choose straight tracks, or draw a line without bends"},
    {"leave --curved, --ab, --guide and --tracks out", "choose straight tracks and no line"},
    {"leave --tracks paper out", "choose tracks parallel to the line"},
    {"plan it again with --route", "plan the whole job"},
    {"name a machine file with flight_altitude_m with --machine", "say how high it flies"},
    {"with --done or --only leave out", "with land that is done leave out"},
    {"--explain and --front are", "the explanation is"},
    {"--explain and --front know", "the explanation knows"},
    {"or name its layer with --layer", "or choose its layer"},
    {"name one with --layer", "choose one"},
    {"choose one with --layer", "choose one"},
    {"give --layer", "choose the layer"},
    {"give --crs", "choose the coordinate reference system"},
    {"--boundary hard keeps them inside",
     "say that the machine cannot leave the field to turn, and they stay inside"},
    {"a smaller --min-length", "shorter pieces"},
    {"fewer --headlands", "fewer headland passes"},
    {"--boundary soft, by which swaths may run past the edge", "a field that the machine can leave"},
    {"nothing is worked there without --width", "nothing is worked there unless you give the working width"},
    {"give --headings from-track", "take the headings from the track"},
    {"give --headings math", "read the headings as mathematical angles"},
    {"give --headings compass", "read the headings as compass angles"},
    {"without --engine mesh", "with the exact engine"},
    {"belongs to --avoid paper: give that too",
     "belongs to the rule of Versleijen at obstacles: choose that"},
    {"--direction-tolerance", "the direction tolerance"},
    {"--avoid-threshold", "the avoid threshold"},
    {"--avoid-room", "the room for detours"},
    {"--obstacle-headlands", "the number of passes round obstacles"},
    {"--obstacle-size", "the size of points and lines"},
    {"--cell-direction", "the direction of cells"},
    {"--decomposition", "the angle at which corners divide"},
    {"--short-edge", "the short edge"},
    {"--min-length", "the shortest piece"},
    {"--min-area", "the least area"},
    {"--guide-where", "the choice of a line"},
    {"--log-crs", "the coordinate reference system of the log"},
    {"--pass-sequence", "the sequence of headland passes"},
    {"--headland-time", "the time of headland passes"},
    {"--headlands", "the number of headland passes"},
    {"--spacing", "the spacing of tracks driven"},
    {"--order", "the order of tracks"},
    {"--start", "the start of the route"},
    {"--end", "the end of the route"},
    {"--clearance", "the clearance"},
    {"--obstacles", "the file of obstacles"},
    {"--passable", "the file of passable strips"},
    {"--boundary", "the boundary"},
    {"--strategy", "the strategy"},
    {"--minimise", "what to minimise"},
    {"--end-rule", "the end rule"},
    {"--headings", "the reading of headings"},
    {"--columns", "the columns"},
    {"--weights", "the weights"},
    {"--machine", "the machine"},
    {"--curved", "curved tracks"},
    {"--tracks", "the kind of tracks"},
    {"--prices", "the prices"},
    {"--radius", "the turning radius"},
    {"--layer", "the layer"},
    {"--width", "the working width"},
    {"--guide", "the line"},
    {"--where", "the choice of features"},
    {"--avoid", "avoiding"},
    {"--merge", "the merging angle"},
}};

/// "a smaller --clearance" becomes "a smaller clearance": an article stands only where none can be there yet.
bool has_article(std::string_view before) {
  constexpr std::array<std::string_view, 10> kBefore = {
      "smaller ", "larger ", "shorter ", "longer ", "another ", "other ", "right ", " a ", " the ", " no "};
  return std::any_of(kBefore.begin(), kBefore.end(),
                     [&](std::string_view word) { return before.ends_with(word); });
}

bool goes_on(const std::string& text, std::size_t at) {
  return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '-');
}

}  // namespace

std::string in_page_words(std::string sentence) {
  for (const auto& [from, to] : kWords)
    for (std::size_t at = sentence.find(from); at != std::string::npos; at = sentence.find(from, at)) {
      if (goes_on(sentence, at + from.size())) {
        at += from.size();
        continue;
      }
      constexpr std::string_view kThe = "the ";
      const std::string_view before = std::string_view(sentence).substr(0, at);
      const std::string_view words =
          to.starts_with(kThe) && has_article(before) ? to.substr(kThe.size()) : to;
      sentence.replace(at, from.size(), words);
      at += words.size();
    }
  return sentence;
}

nlohmann::ordered_json summary_in_page_words(nlohmann::ordered_json summary) {
  if (summary.contains("warnings"))
    for (nlohmann::ordered_json& warning : summary["warnings"])
      warning = in_page_words(warning.get<std::string>());
  return summary;
}

}  // namespace tramline::server
