// SPDX-License-Identifier: Apache-2.0
// Codecs of the values of a fit file that may be written in several ways.
#include <array>
#include <utility>

#include "driver/calibrate/fit_text.hpp"

namespace slipbench::driver::yaml {

using namespace calibrate;  // specialisations belong to the namespace of their template

namespace {

Json any_of(base::json::Array alternatives) {
  Json schema;
  schema["anyOf"] = Json(std::move(alternatives));
  return schema;
}

Json plain(std::string_view type) {
  Json schema;
  schema["type"] = type;
  return schema;
}

/// A map, or a text that stands for one of its members.
template <class Text>
bool read_short(Binder& binder, const Node& node, const Path& path, const KeyInfo& info,
                At<std::string> Text::*member, std::string_view wanted, Text& out) {
  if (node.is_map()) return read_struct(binder, node, path, out);
  if (!node.is_scalar()) {
    binder.wrong_kind(node, path, wanted);
    return false;
  }
  return Codec<At<std::string>>::read(binder, node, path, info, out.*member);
}

template <class Text>
Json short_schema() {
  return any_of({plain("string"), struct_schema<Text>()});
}

}  // namespace

bool Codec<DataColumnText>::read(Binder& binder, const Node& node, const Path& path,
                                 const KeyInfo& info, DataColumnText& out) {
  return read_short(binder, node, path, info, &DataColumnText::column, wanted(info), out);
}
Json Codec<DataColumnText>::schema(const KeyInfo&) { return short_schema<DataColumnText>(); }
std::string Codec<DataColumnText>::wanted(const KeyInfo&) {
  return "a column's name, or {column: ..., unit: ...}";
}
void Codec<DataColumnText>::rows(const std::string& path, std::vector<KeyRow>& rows) {
  struct_rows<DataColumnText>(path, rows);
}

bool Codec<OverColumnText>::read(Binder& binder, const Node& node, const Path& path,
                                 const KeyInfo& info, OverColumnText& out) {
  return read_short(binder, node, path, info, &OverColumnText::quantity, wanted(info), out);
}
Json Codec<OverColumnText>::schema(const KeyInfo&) { return short_schema<OverColumnText>(); }
std::string Codec<OverColumnText>::wanted(const KeyInfo&) {
  return "a result column, or {quantity: ..., column: ..., unit: ...}";
}
void Codec<OverColumnText>::rows(const std::string& path, std::vector<KeyRow>& rows) {
  struct_rows<OverColumnText>(path, rows);
}

bool Codec<CompareText>::read(Binder& binder, const Node& node, const Path& path,
                              const KeyInfo& info, CompareText& out) {
  return read_short(binder, node, path, info, &CompareText::column, wanted(info), out);
}
Json Codec<CompareText>::schema(const KeyInfo&) { return short_schema<CompareText>(); }
std::string Codec<CompareText>::wanted(const KeyInfo&) {
  return "a column's name, or {column: ..., unit: ..., weight: ...}";
}
void Codec<CompareText>::rows(const std::string& path, std::vector<KeyRow>& rows) {
  struct_rows<CompareText>(path, rows);
}

bool Codec<HoldoutText>::read(Binder& binder, const Node& node, const Path& path, const KeyInfo&,
                              HoldoutText& out) {
  return read_struct(binder, node, path, out.experiment);
}
Json Codec<HoldoutText>::schema(const KeyInfo&) { return struct_schema<ExperimentText>(); }
std::string Codec<HoldoutText>::wanted(const KeyInfo&) { return "an experiment"; }
void Codec<HoldoutText>::rows(const std::string&, std::vector<KeyRow>&) {}

bool Codec<BoundsText>::read(Binder& binder, const Node& node, const Path& path,
                             const KeyInfo& info, BoundsText& out) {
  if (!node.is_sequence() || node.size() != 2) {
    binder.wrong_kind(node, path, wanted(info));
    return false;
  }
  bool good = true;
  const auto side = [&](std::size_t i) -> std::optional<double> {
    if (node[i].is_scalar() && node[i].text() == "none") return std::nullopt;
    const auto number = binder.number(node[i], path / i, info);
    good = good && number.has_value();
    return number;
  };
  out.lower = side(0);
  out.upper = side(1);
  return good;
}
Json Codec<BoundsText>::schema(const KeyInfo& info) {
  Json none;
  none["const"] = "none";
  Json schema;
  schema["type"] = "array";
  schema["items"] = any_of({Codec<double>::schema(info), std::move(none)});
  schema["minItems"] = 2;
  schema["maxItems"] = 2;
  return schema;
}
std::string Codec<BoundsText>::wanted(const KeyInfo&) {
  return "a list [lowest, highest] with 'none' for an open end";
}
void Codec<BoundsText>::rows(const std::string&, std::vector<KeyRow>&) {}

namespace {

struct RobustLoss {
  std::string_view name;
  fit::Loss::Kind kind;
};
constexpr std::array kRobust{RobustLoss{"huber", fit::Loss::Kind::kHuber},
                             RobustLoss{"soft_l1", fit::Loss::Kind::kSoftL1}};
constexpr std::string_view kSquares = "squares";

}  // namespace

bool Codec<LossText>::read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info,
                           LossText& out) {
  if (node.is_scalar()) {
    if (node.text() == kSquares) return true;
    for (const RobustLoss& robust : kRobust) {
      if (node.text() != robust.name) continue;
      const std::string name(robust.name);
      binder.error(node, path, "'" + name + "' needs the residual at which it begins",
                   "write {" + name + ": 0.5}");
      return false;
    }
  } else if (node.is_map() && node.size() == 1) {
    const Entry entry = node.entry(0);
    for (const RobustLoss& robust : kRobust) {
      if (entry.key.text() != robust.name) continue;
      out.loss.kind = robust.kind;
      return Codec<double>::read(binder, entry.value, path / robust.name,
                                 KeyInfo{.bounds = law::kPositive}, out.loss.threshold);
    }
    std::vector<std::string_view> names;
    for (const RobustLoss& robust : kRobust) names.push_back(robust.name);
    binder.unknown_key(entry.key, path / entry.key.text(), names);
    return false;
  }
  binder.wrong_kind(node, path, wanted(info));
  return false;
}
Json Codec<LossText>::schema(const KeyInfo&) {
  Json squares;
  squares["const"] = kSquares;
  base::json::Array alternatives = {std::move(squares)};
  for (const RobustLoss& robust : kRobust) {
    Json map;
    map["type"] = "object";
    map["properties"][robust.name] = Codec<double>::schema(KeyInfo{.bounds = law::kPositive});
    Json required = Json(base::json::Array{});
    required.push_back(robust.name);
    map["required"] = std::move(required);
    map["additionalProperties"] = false;
    alternatives.push_back(std::move(map));
  }
  return any_of(std::move(alternatives));
}
std::string Codec<LossText>::wanted(const KeyInfo&) {
  return "squares, {huber: THRESHOLD} or {soft_l1: THRESHOLD}";
}
void Codec<LossText>::rows(const std::string&, std::vector<KeyRow>&) {}

}  // namespace slipbench::driver::yaml
