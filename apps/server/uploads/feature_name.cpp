#include "server/uploads/feature_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "tramline/io/land/read_fields.h"
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

io::VectorQuery query_of(const std::string& file, const std::string& layer) {
  io::VectorQuery out;
  out.file = file;
  out.layer = layer;
  return out;
}

RawFeature with_attributes(const std::string& file, const std::string& layer, long long fid) {
  io::VectorQuery query = query_of(file, layer);
  query.fid = fid;
  query.every_attribute = true;
  return io::read_fields(query).layers.front().features.front();
}

/// Empty where nobody gave it a name.
std::string given_name(const RawFeature& feature) {
  std::string name = feature_name(feature.attributes);
  return name.empty() ? feature.id : name;
}

}  // namespace

std::string feature_name(const std::map<std::string, std::string>& attributes) {
  std::string name = first_of(attributes, kNames);
  return name.empty() ? first_of(attributes, kNumbers) : name;
}

std::string feature_crop(const std::map<std::string, std::string>& attributes) {
  return first_of(attributes, kCrops);
}

std::string name_in_file(const std::string& file, const std::string& layer, long long fid) {
  return given_name(with_attributes(file, layer, fid));
}

std::string name_in_upload(const Upload& upload, const std::string& layer, const RawFeature& feature,
                           long long in_layer) {
  if (std::string name = given_name(feature); !name.empty()) return name;
  const std::string of = id_in_its_name(upload, layer);
  return in_layer == 1 ? of : fmt::format("{}, field {}", of, feature.fid);
}

std::string name_in_upload(const Upload& upload, const std::string& layer, long long fid) {
  const std::string file = upload.path.string();
  io::VectorQuery one = query_of(file, layer);
  one.limit = 1;
  const RawLayer counted = io::read_fields(one).layers.front();
  return name_in_upload(upload, counted.name, with_attributes(file, counted.name, fid), counted.matching);
}

std::string with_name(std::string sentence, const std::string& name) {
  constexpr std::string_view kBefore = "feature '", kAfter = "': ";
  const std::size_t called = sentence.find(kBefore), begin = called + kBefore.size();
  if (called == std::string::npos) return sentence;
  if (const std::size_t end = sentence.find(kAfter, begin); end != std::string::npos)
    sentence.replace(begin, end - begin, name);
  return sentence;
}

}  // namespace tramline::server
