#include "tramline/render/page/contact_sheet.h"
#include "support/refusals.h"

#include <gtest/gtest.h>

#include "sample_plan.h"
#include "tramline/geometry/error.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::render {
namespace {

TEST(ContactSheet, PutsPicturesInRows) {
  const Folder folder;
  draw_plan(sample_plan(), folder / "a.png", {800});
  const std::filesystem::path a = folder / "a.png";
  contact_sheet({a, a, a}, {"one", "two", "three"}, folder / "three.png", 2);
  contact_sheet({a}, {"one"}, folder / "one.png", 2);
  const Pixels three(folder / "three.png");
  const Pixels one(folder / "one.png");
  EXPECT_GT(three.width(), 1.9 * one.width());
  EXPECT_GT(three.height(), 1.9 * one.height() - 40);
  contact_sheet({a, a, a}, {"one", "two", "three"}, folder / "again.png", 2);
  EXPECT_EQ(bytes_of(folder / "three.png"), bytes_of(folder / "again.png"));
}

TEST(ContactSheet, RefusesWhatItCannotShow) {
  const Folder folder;
  draw_plan(sample_plan(), folder / "a.png", {800});
  std::ofstream(folder / "text.png") << "no picture";
  const std::filesystem::path a = folder / "a.png";
  const std::filesystem::path out = folder / "sheet.png";
  EXPECT_REFUSED(contact_sheet({}, {}, out, 2));
  EXPECT_REFUSED(contact_sheet({a}, {}, out, 2));
  EXPECT_REFUSED(contact_sheet({a}, {"a"}, out, 0));
  EXPECT_REFUSED(contact_sheet({a}, {"a"}, folder / "sheet.gif", 1));
  EXPECT_REFUSED(contact_sheet({a, folder / "none.png"}, {"a", "b"}, out, 2));
  EXPECT_REFUSED(contact_sheet({a, folder / "text.png"}, {"a", "b"}, out, 2));
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace tramline::render
