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

}  // namespace
}  // namespace tramline::io
