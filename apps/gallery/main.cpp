// tramline_gallery OUT.png PNG...: many pictures on one sheet, for looking over a whole set of plans.
// Exit codes as everywhere: 0 done, 1 the run failed, 2 the input is at fault.

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/render/page/contact_sheet.h"

namespace {

// About as wide as high, for pictures a little wider than high; never wider than six.
int columns_for(std::size_t pictures) {
  const int square = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(pictures))));
  return square < 6 ? square : 6;
}

void run(int argc, char** argv) {
  if (argc < 3) throw tramline::bad_input("usage: tramline_gallery OUT.png PNG...");
  std::vector<std::filesystem::path> pictures(argv + 2, argv + argc);
  std::vector<std::string> captions;
  for (const std::filesystem::path& picture : pictures) captions.push_back(picture.stem().string());
  tramline::render::contact_sheet(pictures, captions, argv[1], columns_for(pictures.size()));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(argc, argv);
    return 0;
  } catch (const tramline::Error& error) {
    std::fprintf(stderr, "tramline_gallery: %s\n", error.what());
    return error.kind() == tramline::ErrorKind::kBadInput ? 2 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tramline_gallery: %s\n", error.what());
    return 1;
  }
}
