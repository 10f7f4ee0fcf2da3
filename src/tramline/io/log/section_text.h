#pragma once
// States of sections as tables write them.

#include <cstddef>
#include <optional>
#include <string_view>

#include "tramline/model/work_log.h"

namespace tramline::io {

/// States of sections, from left to right.
struct SectionText {
  std::size_t count = 0;  ///< sections that there are; 0: the text does not tell
  bool known = false;     ///< at least one state is known; the others count as off
  SectionStates states;
};

/// The end of the machine at which signs begin.
enum class SectionOrder { kFromLeft, kFromRight };

/// A sign for each section: 1 on, 0 off, - (or blank, or ?) not known; nullopt for other signs and for more
/// than kMostSections.
std::optional<SectionText> section_signs(std::string_view text, SectionOrder order);

/// ISO 11783-11, DDI 161: two bits a section, the first section in the lowest bits: 0 off, 1 on, 2 error,
/// 3 not installed. As a decimal number, as hexadecimal digits (with 0x, or with letters among them), or
/// sixteen digits 0 to 3 written out. Sections not installed at the end are left out of `count`; it is 0
/// where none is said to be missing, because machines also write 0 for those.
std::optional<SectionText> condensed_sections(std::string_view text);

}  // namespace tramline::io
