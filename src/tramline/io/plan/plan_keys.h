#pragma once
// Converts the values that only plans have to the texts of the table `metadata`, and back.

#include <optional>
#include <string>
#include <vector>

#include "tramline/geometry/path/path.h"
#include "tramline/io/field/field_values.h"
#include "tramline/model/plan.h"

namespace tramline::io {

/// Writes words by their names, angles in degrees and radians, and shapes in the coordinates of the file.
class PlanKeyWriter : public FieldKeyWriter {
 public:
  using FieldKeyWriter::operator();
  /// `offset` leads from local metres to the coordinates of the file.
  PlanKeyWriter(Metadata& out, Point offset) : FieldKeyWriter(out), offset_(offset) {}
  void operator()(const std::string& key, EndRule value) const { out()[key] = name(value); }
  void operator()(const std::string& key, EdgeKind value) const { out()[key] = name(value); }
  void operator()(const std::string& key, Strategy value) const { out()[key] = name(value); }
  void operator()(const std::string& key, CellDirection value) const { out()[key] = name(value); }
  void operator()(const std::string& key, Avoidance value) const { out()[key] = name(value); }
  void operator()(const std::string& key, TrackShape value) const { out()[key] = name(value); }
  void operator()(const std::string& key, TrackConstruction value) const { out()[key] = name(value); }
  void operator()(const std::string& key, AbAnchor value) const { out()[key] = name(value); }
  void operator()(const std::string& key, HeadlandConstruction value) const { out()[key] = name(value); }
  void operator()(const std::string& key, PlanOrigin value) const { out()[key] = name(value); }
  void operator()(const std::string& key, HeadlandRule value) const { out()[key] = name(value); }
  void operator()(const std::string& key, TurnPlanning value) const { out()[key] = name(value); }
  /// Degrees are for people; radians are what is read back, to the bit.
  void operator()(const std::string& key, Angle value) const;
  void operator()(const std::string& key, const std::vector<int>& values) const;
  void operator()(const std::string& key, const std::vector<Point>& line) const;
  void operator()(const std::string& key, const Path& path) const;
  void operator()(const std::string& key, const std::vector<Path>& paths) const;

 private:
  Point offset_;
};

/// The inverse. Throws as KeyReader does, also for words that are unknown.
class PlanKeyReader : public FieldKeyReader {
 public:
  using FieldKeyReader::FieldKeyReader;
  using FieldKeyReader::operator();
  void operator()(const std::string& key, EndRule& value) { value = word(key, end_rule_named(text(key))); }
  void operator()(const std::string& key, EdgeKind& value) { value = word(key, edge_kind_named(text(key))); }
  void operator()(const std::string& key, Strategy& value) { value = word(key, strategy_named(text(key))); }
  void operator()(const std::string& key, CellDirection& value) {
    value = word(key, cell_direction_named(text(key)));
  }
  void operator()(const std::string& key, Avoidance& value) { value = word(key, avoidance_named(text(key))); }
  void operator()(const std::string& key, TrackShape& value) {
    value = word(key, track_shape_named(text(key)));
  }
  void operator()(const std::string& key, TrackConstruction& value) {
    value = word(key, track_construction_named(text(key)));
  }
  void operator()(const std::string& key, AbAnchor& value) { value = word(key, ab_anchor_named(text(key))); }
  void operator()(const std::string& key, HeadlandConstruction& value) {
    value = word(key, headland_construction_named(text(key)));
  }
  void operator()(const std::string& key, PlanOrigin& value) {
    value = word(key, plan_origin_named(text(key)));
  }
  void operator()(const std::string& key, HeadlandRule& value) {
    value = word(key, headland_rule_named(text(key)));
  }
  void operator()(const std::string& key, TurnPlanning& value) {
    value = word(key, turn_planning_named(text(key)));
  }
  void operator()(const std::string& key, Angle& value);
  void operator()(const std::string& key, std::vector<int>& values);
  void operator()(const std::string& key, std::vector<Point>& line);
  void operator()(const std::string& key, Path& path);
  void operator()(const std::string& key, std::vector<Path>& paths);

  /// What is taken off all coordinates from now on.
  void shift_by(Point offset) { offset_ = offset; }

 private:
  template <class Choice>
  Choice word(const std::string& key, std::optional<Choice> choice) const {
    if (!choice) throw wrong(key, "a word this version of tramline knows");
    return *choice;
  }
  Point offset_{};
};

/// A reader of those keys alone that the file has.
class PresentKeys {
 public:
  PresentKeys(const Metadata& metadata, PlanKeyReader& reader) : metadata_(metadata), reader_(reader) {}
  template <class Value>
  void operator()(const std::string& key, Value& value) {
    if (metadata_.contains(key)) reader_(key, value);
  }

 private:
  const Metadata& metadata_;
  PlanKeyReader& reader_;
};

}  // namespace tramline::io
