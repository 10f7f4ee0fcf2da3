// Names as terminals show them.

#include "tramline/io/terminal/designators.h"

#include <gtest/gtest.h>

namespace tramline::io {
namespace {

TEST(Designators, LettersWithMarksBecomeLetters) {
  EXPECT_EQ(in_ascii("Große Breite"), "Grosse Breite");
  EXPECT_EQ(in_ascii("Grüner Weg Öst"), "Gruener Weg Oest");
  EXPECT_EQ(in_ascii("Peña çà"), "Pena ca");
  EXPECT_EQ(in_ascii("Łąka Żółta"), "Laka Zolta");
  EXPECT_EQ(in_ascii("Přední Šťáva ů"), "Predni Stava u");
  EXPECT_EQ(in_ascii("Čačak Đ ž"), "Cacak D z");
  EXPECT_EQ(in_ascii("Ősi út ű"), "Osi ut u");
  EXPECT_EQ(in_ascii("Åker øst"), "Aaker oest");
  EXPECT_EQ(in_ascii("Ğ ı ş İ"), "G i s I");
}

TEST(Designators, GreekAndCyrillicAreTranscribed) {
  EXPECT_EQ(in_ascii("Поле Щука Ёлка"), "Pole Shchuka Elka");
  EXPECT_EQ(in_ascii("Нива № 3"), "Niva _ 3");
  EXPECT_EQ(in_ascii("їжак Ґ"), "yizhak _");
  EXPECT_EQ(in_ascii("Θάσος Ωμέγα"), "Thasos Omega");
}

TEST(Designators, MarksOfTheirOwnAreLeftOutAndOtherCharactersReplaced) {
  EXPECT_EQ(in_ascii("Mu\xCC\x88hle"), "Muhle");
  EXPECT_EQ(in_ascii("a\tb\nc"), "a_b_c");
  EXPECT_EQ(in_ascii("\xFF\xC3 x\xE4"), "__ x_");
  EXPECT_EQ(in_ascii("  blanks  "), "blanks");
  EXPECT_EQ(in_ascii("田"), "_");
}

TEST(Designators, NoTwoAreAlikeAndNoneIsTooLong) {
  Designators names;
  const std::string name(40, 'x');
  EXPECT_EQ(names.unique(name, "Field 1"), std::string(32, 'x'));
  EXPECT_EQ(names.unique(name, "Field 2"), std::string(30, 'x') + " 2");
  EXPECT_EQ(names.unique(name + "y", "Field 3"), std::string(30, 'x') + " 3");
  EXPECT_EQ(names.unique("田田", "Field 4"), "Field 4");
  EXPECT_EQ(names.unique("", "Field 4"), "Field 4 2");
  EXPECT_EQ(names.unique(std::string(31, 'y') + " z", "Field 6"), std::string(31, 'y'));
}

// Most terminals and cards do not tell capital letters from small ones.
TEST(Designators, ThatDifferInCapitalsOnlyAreAlike) {
  Designators names;
  EXPECT_EQ(names.unique("Mill", "Field 1"), "Mill");
  EXPECT_EQ(names.unique("MILL", "Field 2"), "MILL 2");
}

TEST(Designators, OfFoldersAreThoseOfAnyFileSystem) {
  Designators names;
  EXPECT_EQ(names.unique_folder("f", "Field 1"), "f");
  EXPECT_EQ(names.unique_folder("F", "Field 2"), "F 2");
  EXPECT_EQ(names.unique_folder("a/b:c", "Field 3"), "a_b_c");
  EXPECT_EQ(names.unique_folder(std::string(31, 'x') + ".y", "Field 4"), std::string(31, 'x'));
  EXPECT_EQ(names.unique_folder("..", "Field 5"), "Field 5");
  EXPECT_EQ(names.unique_folder("con", "Field 6"), "Field 6");
  EXPECT_EQ(names.unique_folder("Lpt1.old", "Field 7"), "Field 7");
  EXPECT_EQ(names.unique_folder("Lpt10", "Field 8"), "Lpt10");
}

}  // namespace
}  // namespace tramline::io
