#include "server/uploads/feature_name.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "tramline/io/vector/lower_case.h"

namespace tramline::server {
namespace {

/// Names that people gave, the more telling attribute first.
constexpr std::array<std::string_view, 32> kNames = {
    "field_name", "fieldname", "field name",  "designator", "partfield", "feldname",   "schlagname",
    "schlagbez",  "flurname",  "bezeichnung", "bezeichnun", "plotname",  "parcel_nam", "parcelname",
    "name",       "naam",      "perceelnaam", "navn",       "namn",      "nimi",       "nom",
    "nom_parcel", "nombre",    "nome",        "nazwa",      "nazev",     "nazov",      "denumire",
    "title",      "field",     "feld",        "label"};

/// Numbers by which registers tell land apart.
constexpr std::array<std::string_view, 34> kNumbers = {
    "flik",       "feldblock", "fb_flik",    "flik_id",   "fbi",       "schlagnr",  "schlag",
    "schlagnumm", "nummer",    "marknr",     "mark_nr",   "markblok",  "blockid",   "blokid",
    "skiftesnr",  "lohko",     "peruslohko", "parcel_id", "parcelid",  "id_parcel", "num_ilot",
    "num_parcel", "perceelid", "perceel_id", "zkod_dpb",  "kod_dpb",   "kod",       "nr_dzialki",
    "lpis_id",    "lpis",      "gerk_pid",   "refcat",    "reference", "code"};

constexpr std::array<std::string_view, 18> kCrops = {
    "crop",       "crop_name", "cropname", "kultur",   "kulturart", "culture",
    "culture_d",  "cultura",   "cultivo",  "afgroede", "groda",     "gewas",
    "code_cultu", "plodina",   "uprawa",   "kasvi",    "nutzung",   "src_gewas"};

bool is_blank(const std::string& text) { return text.find_first_not_of(" \t") == std::string::npos; }

std::string first_of(const std::map<std::string, std::string>& attributes,
                     std::span<const std::string_view> keys) {
  for (const std::string_view key : keys)
    for (const auto& [name, value] : attributes)
      if (io::lower_case(name) == key && !is_blank(value)) return value;
  return "";
}

}  // namespace

std::string feature_name(const std::map<std::string, std::string>& attributes) {
  std::string name = first_of(attributes, kNames);
  return name.empty() ? first_of(attributes, kNumbers) : name;
}

std::string feature_crop(const std::map<std::string, std::string>& attributes) {
  return first_of(attributes, kCrops);
}

}  // namespace tramline::server
