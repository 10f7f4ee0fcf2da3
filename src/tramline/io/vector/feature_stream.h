#pragma once
// The features of one layer, some at a time: for files with more of them than memory holds.

#include <memory>
#include <string>
#include <vector>

#include "tramline/io/vector/read_vector.h"
#include "tramline/model/raw_feature.h"

namespace tramline::io {

/// One file that is kept open. To be used by one thread at a time.
class FeatureStream {
 public:
  /// Opens the layer that the query asks for; its fid and limit are of no account. Throws bad_input as
  /// read_vector().
  explicit FeatureStream(const VectorQuery& query);
  FeatureStream(const FeatureStream&) = delete;
  FeatureStream& operator=(const FeatureStream&) = delete;
  ~FeatureStream();

  /// Features that match the query.
  long long count() const;
  /// The files on disk that hold the features, sorted: of a Shapefile also its attributes, projection and
  /// encoding, of a folder those of all its layers, of an archive the archive. Indexes and journals are left
  /// out: they say nothing that the others do not. Empty: the features come from a database.
  std::vector<std::string> files() const;
  /// The features from number `first`, counted from 0 in the order of the file, at most `most` of them; no
  /// layer where there are none. Going on where the last call ended costs least; features in between are
  /// passed over, and a step back begins anew. Throws bad_input where the file is damaged. O(what is passed).
  RawDataset read(long long first, long long most);

 private:
  struct Open;
  std::unique_ptr<Open> open_;
};

}  // namespace tramline::io
