#include "tramline/io/vector/feature_stream.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/vector/choose_layers.h"
#include "tramline/io/vector/gdal_drivers.h"
#include "tramline/io/vector/gdal_messages.h"
#include "tramline/io/vector/layer_reading.h"
#include "tramline/io/vector/locate_dataset.h"
#include "tramline/io/vector/open_dataset.h"

namespace tramline::io {
namespace {

/// Whether programs write this file of a dataset when they only look at it.
bool may_be_made_anew(const std::string& name) {
  constexpr std::array<std::string_view, 8> kEndings{".sbn", ".sbx", ".qix", ".idm",
                                                     ".ind", "-wal", "-shm", "-journal"};
  return std::any_of(kEndings.begin(), kEndings.end(),
                     [&](std::string_view ending) { return name.ends_with(ending); });
}

}  // namespace

struct FeatureStream::Open {
  VectorQuery query;
  std::unique_ptr<ConnectionsAllowed> connections;
  GDALDatasetUniquePtr dataset;
  OGRLayer* layer = nullptr;
  RawDataset bare;  ///< with the layer, without features
  long long count = 0;
  long long next = 0;  ///< number of the feature that the layer gives next

  void pass_over(long long features) {
    for (; features > 0; --features, ++next)
      if (OGRFeatureUniquePtr(layer->GetNextFeature()) == nullptr) return;
  }
};

FeatureStream::FeatureStream(const VectorQuery& query) : open_(std::make_unique<Open>()) {
  register_gdal_drivers();
  GdalMessages messages;
  open_->query = query;
  open_->connections = connections_for(query.file);
  open_->dataset = open_dataset(query.file, query.layer, messages);
  open_->bare = bare_dataset(*open_->dataset, query);
  const std::vector<OGRLayer*> layers = choose_layers(*open_->dataset, query, open_->bare.skipped);
  assert(layers.size() == 1);
  open_->layer = layers.front();
  open_->bare.layers.push_back(bare_layer(*open_->layer, query));
  filter(*open_->layer, query, place_of(*open_->layer, query), messages);
  messages.clear();
  open_->count = open_->layer->GetFeatureCount(true);
  check_reading(*open_->layer, query, place_of(*open_->layer, query), messages);
  if (open_->count <= 0)
    throw bad_input(fmt::format("'{}' holds no features{}", shown_name(query.file),
                                query.where.empty() ? "" : " that match --where"));
  open_->layer->ResetReading();
}

FeatureStream::~FeatureStream() = default;

long long FeatureStream::count() const { return open_->count; }

std::vector<std::string> FeatureStream::files() const {
  std::set<std::string> out;
  const auto add = [&](const std::string& name) {
    std::error_code error;
    if (std::filesystem::is_regular_file(name, error) && !may_be_made_anew(name)) out.insert(name);
  };
  add(open_->query.file);
  char** const listed = open_->dataset->GetFileList();
  for (char** name = listed; name != nullptr && *name != nullptr; ++name) add(*name);
  CSLDestroy(listed);
  return {out.begin(), out.end()};
}

RawDataset FeatureStream::read(long long first, long long most) {
  assert(first >= 0 && most >= 0);
  GdalMessages messages;
  OGRLayer& layer = *open_->layer;
  const std::string place = place_of(layer, open_->query);
  if (first < open_->next) {
    layer.ResetReading();
    open_->next = 0;
  }
  open_->pass_over(first - open_->next);
  RawDataset out = open_->bare;
  RawLayer& read = out.layers.front();
  const AxisOrder axes = axis_order(layer.GetSpatialRef());
  for (; most > 0; --most) {
    const OGRFeatureUniquePtr feature(layer.GetNextFeature());
    if (!feature) break;
    ++open_->next;
    read.features.push_back(raw_feature(*feature, axes, open_->query));
  }
  check_reading(layer, open_->query, place, messages);
  read.matching = static_cast<long long>(read.features.size());
  if (read.features.empty()) out.layers.clear();
  return out;
}

}  // namespace tramline::io
