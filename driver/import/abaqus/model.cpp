// SPDX-License-Identifier: Apache-2.0
#include "driver/import/abaqus/model.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "driver/base/text/format_number.hpp"
#include "driver/import/abaqus/element_sets.hpp"
#include "driver/import/abaqus/keyword_list.hpp"
#include "driver/import/abaqus/rows.hpp"

namespace slipbench::driver::abaqus {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Place of an instance: a point of its part goes to `turn` * point + `shift`.
struct Instance {
  std::string name;  ///< as people know it
  std::string label;
  std::string part;
  Matrix3d turn = Matrix3d::Identity();
  Vector3d shift = Vector3d::Zero();
};

/// Node by the part that it belongs to (empty: the assembly) and its number.
struct NodeName {
  std::string part;
  long number = 0;
  friend bool operator<(const NodeName& a, const NodeName& b) {
    return std::tie(a.part, a.number) < std::tie(b.part, b.number);
  }
};

struct Element {
  std::string part;
  long number = 0;
  std::string_view where;
  bool plane = false;
  std::array<std::string_view, 2> nodes = {};
  std::set<std::string> sets = {};
};

struct Section {
  const Block* block = nullptr;
  std::string part;
  std::string set;
  std::string behavior = {};
  std::vector<std::string> types = {};
  std::string_view types_where = {};
  std::array<std::string, 2> orientations = {};
  std::optional<double> number = std::nullopt;
};

/// Takes off what turned axes leave of rounding, in numbers that people wrote with a few digits.
double rounded(double value, double scale) {
  constexpr double kNothing = 1e-12;
  return std::abs(value) <= kNothing * scale ? 0.0 : base::rounded_number(value, 12);
}

/// Goes through a deck once, and makes the model of what it found.
class Reader {
 public:
  explicit Reader(const KeywordDeck& deck) : deck_(deck), sets_(deck) {}

  Model read() {
    const std::vector<Block>& blocks = deck_.blocks();
    for (std::size_t at = 0; at < blocks.size();) {
      if (blocks[at].keyword == "CONNECTOR BEHAVIOR") {
        const Block& head = blocks[at];
        Behavior behavior = read_behavior(deck_, at);
        const Behavior* const first = find_behavior(label_of(behavior.name));
        if (first != nullptr && !behavior.name.empty()) {
          deck_.error(head.where, head, "has the name of the one in " + deck_.place(first->where));
        }
        behaviors_.try_emplace(label_of(behavior.name), model_.behaviors.size());
        model_.behaviors.push_back(std::move(behavior));
      } else {
        read_block(blocks[at]);
        ++at;
      }
    }
    if (step_) {
      deck_.error(step_->where, *step_block_, "has no *END STEP: the deck ends in this step");
    }
    make_connectors();
    find_positions();
    if (!others_ && elements_.size() == 1 && model_.connectors.size() == 1) {
      const std::array nodes{label_of(elements_[0].nodes[0]), label_of(elements_[0].nodes[1])};
      if (nodes[0].empty() || held_.count(nodes[0]) > 0) model_.connectors[0].alone = nodes;
    }
    return std::move(model_);
  }

 private:
  void read_block(const Block& block) {
    const std::string_view keyword = block.keyword;
    if (keyword == "PART") {
      part_ = label_of(block.value_of("NAME"));
    } else if (keyword == "END PART") {
      part_.clear();
    } else if (keyword == "INSTANCE") {
      read_instance(block);
    } else if (keyword == "NODE") {
      node_blocks_.emplace_back(part_, &block);
    } else if (keyword == "ELEMENT") {
      read_elements(block);
    } else if (keyword == "ORIENTATION") {
      read_orientation(block);
    } else if (keyword == "CONNECTOR SECTION") {
      read_section(block);
    } else if (keyword == "AMPLITUDE") {
      read_amplitude(block);
    } else if (keyword == "STEP") {
      begin_step(block);
    } else if (keyword == "END STEP") {
      end_step();
    } else if (step_) {
      read_in_step(block);
    } else if (keyword == "BOUNDARY") {
      read_boundary(block);
    } else if (keyword == "FRICTION" || keyword == "SURFACE INTERACTION" || keyword == "GAP" ||
               keyword == "HEADING" || keyword == "ASSEMBLY" || keyword == "END ASSEMBLY" ||
               keyword == "END INSTANCE" || keyword == "PARAMETER" || keyword == "ELSET") {
      return;
    } else if (keyword.starts_with("CONNECTOR")) {
      deck_.error(block.where, block, "stands outside of a *CONNECTOR BEHAVIOR");
    } else {
      ++model_.passed_over;
    }
  }

  void read_instance(const Block& block) {
    Instance one{.name = shown(block.value_of("NAME")),
                 .label = label_of(block.value_of("NAME")),
                 .part = label_of(block.value_of("PART"))};
    const std::vector<Row> rows = read_rows(deck_, block, deck_.lines(block), 7, "its place");
    const auto at = [&](std::size_t row, std::size_t i) {
      return rows[row].size() > i ? rows[row][i].value_or(0.0) : 0.0;
    };
    if (!rows.empty()) one.shift = Vector3d(at(0, 0), at(0, 1), at(0, 2));
    if (rows.size() > 1) {
      const Vector3d a(at(1, 0), at(1, 1), at(1, 2));
      const Vector3d b(at(1, 3), at(1, 4), at(1, 5));
      const double angle = at(1, 6) * std::numbers::pi / 180.0;
      if ((b - a).norm() > 0.0) {
        one.turn = Eigen::AngleAxisd(angle, (b - a).normalized()).toRotationMatrix();
        one.shift = a + one.turn * (one.shift - a);
      }
    }
    instance_of_.try_emplace(one.label, instances_.size());
    instances_.push_back(one);
  }

  void read_elements(const Block& block) {
    const std::string type = folded(block.value_of("TYPE"));
    if (type != "CONN3D2" && type != "CONN2D2") {
      others_ = true;
      return;
    }
    const std::string set = label_of(block.value_of("ELSET"));
    for (const Items& items : deck_.lines(block)) {
      Element one{.part = part_,
                  .number = deck_.whole(items.front(), -1),
                  .where = items.front(),
                  .plane = type == "CONN2D2"};
      if (one.number < 1) {
        deck_.error(items.front(), block, "wanted the number of an element, and its two nodes");
        continue;
      }
      for (std::size_t i = 0; i < 2 && i + 1 < items.size(); ++i) one.nodes[i] = items[i + 1];
      if (!set.empty()) one.sets.insert(set);
      elements_.push_back(one);
    }
  }

  void read_orientation(const Block& block) {
    const std::string label = label_of(block.value_of("NAME"));
    const std::string system =
        word_of(deck_, block, "SYSTEM",
                {"RECTANGULAR", "CYLINDRICAL", "SPHERICAL", "Z RECTANGULAR", "USER"});
    const std::string definition =
        word_of(deck_, block, "DEFINITION", {"COORDINATES", "NODES", "OFFSET TO NODES"});
    constexpr std::size_t kMost = 9;
    std::vector<Row> rows;
    for (const Items& items : deck_.lines(block)) {
      const std::vector<Row> row = read_rows(deck_, block, {items}, kMost, "its points");
      rows.insert(rows.end(), row.begin(), row.end());
    }
    if (system != "RECTANGULAR" || definition != "COORDINATES" || rows.empty() ||
        rows[0].size() < 6) {
      return;
    }
    const auto point = [&](std::size_t i) {
      Vector3d v = Vector3d::Zero();
      for (std::size_t k = 0; k < 3; ++k) {
        if (rows[0].size() > 3 * i + k) {
          v[static_cast<Eigen::Index>(k)] = rows[0][3 * i + k].value_or(0.0);
        }
      }
      return v;
    };
    const Vector3d x = point(0) - point(2);
    const Vector3d z = x.cross(point(1) - point(2));
    if (x.norm() == 0.0 || z.norm() == 0.0) return;
    Matrix3d axes;
    axes.col(0) = x.normalized();
    axes.col(2) = z.normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    if (rows.size() > 1 && rows[1].size() > 1 && rows[1][0] && rows[1][1]) {
      const double axis = std::trunc(*rows[1][0]);
      const double angle = *rows[1][1] * std::numbers::pi / 180.0;
      if (axis >= 1.0 && axis <= 3.0) {
        const Vector3d about = axes.col(static_cast<Eigen::Index>(axis) - 1);
        axes = Eigen::AngleAxisd(angle, about).toRotationMatrix() * axes;
      }
    }
    axes_[{part_, label}] = axes;
  }

  void read_section(const Block& block) {
    Section section{.block = &block, .part = part_, .set = label_of(block.value_of("ELSET"))};
    section.behavior = label_of(block.value_of("BEHAVIOR"));
    // A blank line of orientations keeps its place: only commas stand in it, or nothing.
    std::vector<Items> lines;
    deck_.for_each_line(block, [&](std::string_view line) {
      lines.push_back(line == "," ? Items() : split_items(line));
    });
    if (section.set.empty()) deck_.error(block.where, block, "ELSET is missing");
    sets_.expect(section.set, block.where, block);
    if (lines.empty() || lines.front().empty()) {
      deck_.error(block.where, block, "wanted a line with the connection type");
      return;
    }
    section.types_where = lines.front().front();
    for (const std::string_view item : lines.front()) {
      if (!item.empty()) section.types.push_back(folded(item));
    }
    for (std::size_t i = 0; lines.size() > 1 && i < std::min<std::size_t>(2, lines[1].size());
         ++i) {
      section.orientations[i] = label_of(lines[1][i]);
    }
    if (lines.size() > 2 && !lines[2].empty() && !lines[2].front().empty()) {
      const auto number = deck_.number(lines[2].front());
      if (!number) {
        deck_.error(lines[2].front(), block, number.error());
      } else {
        section.number = *number;
      }
    }
    const auto [first, is_new] =
        section_of_set_.try_emplace({section.part, section.set}, sections_.size());
    if (!is_new && !section.set.empty()) {
      deck_.error(block.where, block,
                  "its elements have that of " +
                      deck_.place(sections_[first->second].block->where) + " as well");
    }
    sections_.push_back(section);
  }

  void read_amplitude(const Block& block) {
    Amplitude one{.label = label_of(block.value_of("NAME")), .where = block.where};
    constexpr std::array<std::string_view, 6> kKinds{"TABULAR",        "SMOOTH STEP", "PERIODIC",
                                                     "EQUALLY SPACED", "DECAY",       "MODULATED"};
    const std::string definition = block.value_of("DEFINITION");
    if (!definition.empty()) {
      const FoundName found = find_name(definition, kKinds);
      const auto* const place = std::find(kKinds.begin(), kKinds.end(), found.name);
      one.kind = static_cast<Amplitude::Kind>(std::min<std::ptrdiff_t>(place - kKinds.begin(), 5));
    }
    one.total_time = word_of(deck_, block, "TIME", {"STEP TIME", "TOTAL TIME"}) == "TOTAL TIME";
    one.absolute = word_of(deck_, block, "VALUE", {"RELATIVE", "ABSOLUTE"}) == "ABSOLUTE";
    one.interval = deck_.number(block.value_of("FIXED INTERVAL")).value_or(0.0);
    if (one.kind == Amplitude::Kind::kEquallySpaced && !(one.interval > 0.0)) {
      deck_.error(block.where, block, "FIXED INTERVAL: wanted a number above 0");
    }
    if (const Amplitude* const first = find_amplitude(model_, one.label)) {
      deck_.error(block.where, block, "has the name of the one in " + deck_.place(first->where));
    }
    one.begin = deck_.number(block.value_of("BEGIN")).value_or(0.0);
    one.smoothed = deck_.number(block.value_of("SMOOTH")).value_or(0.0) > 0.0;
    using Kind = Amplitude::Kind;
    const bool pairs = one.kind == Kind::kTabular || one.kind == Kind::kSmoothStep;
    bool sound = true;
    for (Items items : deck_.lines(block)) {
      // Items left out at the end of a line are 0, and those of the next line keep their places.
      while (!items.empty() && items.back().empty()) items.pop_back();
      std::size_t wanted = items.size();
      if (pairs || one.kind == Kind::kPeriodic) wanted += wanted % 2;
      if (one.kind == Kind::kPeriodic && one.numbers.empty()) wanted = std::max(wanted, kHead);
      items.resize(wanted);
      for (std::size_t i = 0; i < wanted; ++i) {
        const std::string_view item = items[i];
        const auto number =
            item.empty() ? tl::expected<double, std::string>(0.0) : deck_.number(item);
        if (!number) {
          // Other kinds have words of their own in their data.
          if (one.kind != Kind::kOther) deck_.error(item, block, number.error());
          sound = false;
          break;
        }
        const std::size_t before = one.numbers.size();
        if (sound && pairs && i % 2 == 0 && before >= 2 && *number < one.numbers[before - 2]) {
          deck_.error(item.empty() ? block.where : item, block,
                      fmt::format("times must not fall: {:g} stands behind {:g}", *number,
                                  one.numbers[before - 2]));
          sound = false;
        }
        one.numbers.push_back(*number);
      }
    }
    model_.amplitudes.emplace(one.label, one);
  }

  void begin_step(const Block& block) {
    if (step_) {
      deck_.error(block.where, block,
                  fmt::format("stands in the step of {}, which has no *END STEP",
                              deck_.place(step_->where)));
    }
    const std::string name = shown(block.value_of("NAME"));
    step_ =
        Step{.name = name.empty() ? fmt::format("step {}", ++steps_) : name, .where = block.where};
    step_block_ = &block;
    if (block.has("AMPLITUDE")) {
      step_->at_once = word_of(deck_, block, "AMPLITUDE", {"RAMP", "STEP"}) == "STEP";
    }
    changes_.clear();
    has_time_ = false;
    change_open_ = false;
  }

  void read_in_step(const Block& block) {
    const std::string_view keyword = block.keyword;
    if (keyword != "FRICTION") change_open_ = false;
    if (step_block_->has("PERTURBATION")) {
      ++model_.passed_over;
      return;
    }
    if (keyword == "STATIC" || keyword == "DYNAMIC" || keyword == "VISCO") {
      has_time_ = true;
      step_->is_static = keyword != "DYNAMIC";
      if (block.has("RIKS")) {
        deck_.warning(block.find("RIKS")->where, block,
                      "the load factor of RIKS is not followed: loads rise with time here");
      }
      const std::vector<Row> rows = read_rows(deck_, block, deck_.lines(block), 8, "times");
      const auto at = [&](std::size_t i) {
        return !rows.empty() && rows[0].size() > i ? rows[0][i].value_or(0.0) : 0.0;
      };
      for (std::size_t i = 0; i < 2; ++i) {
        if (at(i) < 0.0) deck_.error(block.where, block, "wanted times of 0 or more");
      }
      step_->increment = std::max(0.0, at(0));
      if (at(1) > 0.0) step_->period = at(1);
    } else if (keyword == "CONNECTOR MOTION" || keyword == "CONNECTOR LOAD") {
      read_drives(block, keyword == "CONNECTOR LOAD");
    } else if (keyword == "CLOAD" || keyword == "TEMPERATURE" || keyword == "FIELD") {
      read_of_nodes(block);
    } else if (keyword == "BOUNDARY") {
      read_boundary(block);
    } else if (keyword == "CHANGE FRICTION") {
      if (!block.has("ELSET") && !block.has("INTERACTION")) {
        deck_.error(block.where, block, "ELSET or INTERACTION is missing");
      }
      sets_.expect(label_of(block.value_of("ELSET")), block.where, block);
      step_->changes.push_back({.where = block.where,
                                .target = label_of(block.value_of("ELSET")),
                                .amplitude = label_of(block.value_of("AMPLITUDE")),
                                .reset = block.has("RESET")});
      changes_.push_back(&block);
      change_open_ = true;
    } else if (keyword == "FRICTION" && change_open_) {
      if (step_->changes.back().reset) {
        deck_.error(block.where, block, "goes with no *CHANGE FRICTION, RESET");
      }
      step_->changes.back().coefficient = read_coefficient(deck_, block);
    } else {
      ++model_.passed_over;
    }
  }

  /// Returns whether OP=NEW takes away what the steps before have stated.
  bool is_anew(const Block& block) const {
    return word_of(deck_, block, "OP", {"MOD", "NEW"}) == "NEW";
  }

  void read_drives(const Block& block, bool is_load) {
    const bool is_new = is_anew(block);
    (is_load ? step_->new_loads : step_->new_motions) |= is_new;
    const std::string type =
        word_of(deck_, block, "TYPE", {"DISPLACEMENT", "VELOCITY", "ACCELERATION"});
    for (const Items& items : deck_.lines(block)) {
      Drive drive{.where = items.front(),
                  .target = label_of(items.front()),
                  .amplitude = label_of(block.value_of("AMPLITUDE")),
                  .type = type,
                  .is_load = is_load,
                  .fixed = block.has("FIXED"),
                  .user = block.has("USER")};
      const auto component =
          items.size() > 1 ? component_in(deck_, items[1]) : std::optional<int>();
      if (!component) {
        deck_.error(items.front(), block,
                    "wanted a set or an element, a component and a magnitude");
        continue;
      }
      sets_.expect(drive.target, items.front(), block);
      drive.component = *component;
      if (items.size() > 2 && !items[2].empty()) {
        const auto magnitude = deck_.number(items[2]);
        if (!magnitude) {
          deck_.error(items[2], block, magnitude.error());
          continue;
        }
        drive.magnitude = *magnitude;
      }
      step_->drives.push_back(drive);
    }
  }

  /// Loads, temperatures and fields of nodes; which of them are a connector's is found later.
  void read_of_nodes(const Block& block) {
    const bool is_load = block.keyword == "CLOAD";
    const std::string variable = block.value_of("VARIABLE");
    if (is_load && is_anew(block)) step_->new_of_nodes = true;
    for (const Items& items : deck_.lines(block)) {
      Drive drive{.where = items.front(),
                  .target = label_of(items.front()),
                  .amplitude = label_of(block.value_of("AMPLITUDE")),
                  .is_load = true};
      if (!is_load) {
        drive.quantity = block.keyword == "TEMPERATURE"
                             ? "temperature"
                             : "field" + (variable.empty() ? std::string("1") : variable);
      }
      const std::size_t number = is_load ? 2 : 1;
      const auto component =
          is_load && items.size() > 1 ? component_in(deck_, items[1]) : std::optional<int>(1);
      if (!component || items.size() <= number) continue;
      drive.component = *component;
      drive.magnitude = deck_.number(items[number]).value_or(0.0);
      step_->of_nodes.push_back(drive);
    }
  }

  void read_boundary(const Block& block) {
    constexpr std::array<std::string_view, 8> kKinds{"ENCASTRE", "PINNED", "XSYMM",  "YSYMM",
                                                     "ZSYMM",    "XASYMM", "YASYMM", "ZASYMM"};
    for (const Items& items : deck_.lines(block)) {
      const bool all =
          items.size() > 2 && deck_.whole(items[1], 0) == 1 && deck_.whole(items[2], 0) == 6;
      const bool encastre = items.size() > 1 && find_name(items[1], kKinds).name == "ENCASTRE";
      if (all || encastre) held_.insert(label_of(items.front()));
    }
  }

  void end_step() {
    if (!step_) return;
    for (std::size_t i = 0; i < changes_.size(); ++i) {
      const FrictionChange& change = step_->changes[i];
      if (change.reset || change.coefficient || change.target.empty()) continue;
      deck_.error(change.where, *changes_[i], "wants a *FRICTION behind it, or RESET");
    }
    if (has_time_) {
      model_.steps.push_back(std::move(*step_));
    } else {
      model_.notes.push_back(fmt::format("{} ({}) {}", step_->name, deck_.place(step_->where),
                                         step_block_->has("PERTURBATION")
                                             ? "is a perturbation, which changes no state"
                                             : "has no *STATIC or *DYNAMIC"));
    }
    step_.reset();
  }

  const Behavior* find_behavior(const std::string& label) const {
    const auto found = behaviors_.find(label);
    return found == behaviors_.end() ? nullptr : &model_.behaviors[found->second];
  }

  /// The section of an element, by the sets that it is in.
  const Section* section_of(const Element& element) const {
    const Section* found = nullptr;
    for (const std::string& set : element.sets) {
      const auto one = section_of_set_.find({element.part, set});
      if (one == section_of_set_.end()) continue;
      const Section* const section = &sections_[one->second];
      if (found != nullptr) {
        deck_.error(element.where, *section->block,
                    fmt::format("element {} has that of {} as well", element.number,
                                deck_.place(found->block->where)));
      }
      found = section;
    }
    return found;
  }

  void make_connectors() {
    for (Element& element : elements_) {
      if (too_many_) return;
      sets_.add_sets_of(element.part, element.number, element.sets);
      const Section* const section = section_of(element);
      if (section == nullptr) {
        model_.notes.push_back(fmt::format("element {} ({}) has no *CONNECTOR SECTION",
                                           element.number, deck_.place(element.where)));
        continue;
      }
      Connector one{.name = std::to_string(element.number),
                    .set = shown(section->block->value_of("ELSET")),
                    .where = element.where,
                    .types = section->types,
                    .types_where = section->types_where,
                    .number_of_type = section->number};
      one.labels = element.sets;
      one.plane = element.plane;
      if (!section->behavior.empty()) {
        one.behavior = find_behavior(section->behavior);
        if (one.behavior == nullptr) {
          const Parameter* const where = section->block->find("BEHAVIOR");
          deck_.error(where->where, *section->block,
                      "there is no *CONNECTOR BEHAVIOR of that name");
        }
      }
      bool placed = false;
      for (const Instance& instance : instances_) {
        if (too_many_ || element.part.empty() || instance.part != element.part) continue;
        Connector own = one;
        own.name = instance.name + "." + one.name;
        for (const std::string& set : element.sets) own.labels.insert(instance.label + "." + set);
        own.labels.insert(instance.label + "." + one.name);
        sets_.add_sets_of_instance(instance.label, element.number, own.labels);
        add(std::move(own), element, *section, &instance);
        placed = true;
      }
      if (placed || !element.part.empty()) continue;
      one.labels.insert(one.name);
      add(std::move(one), element, *section, nullptr);
    }
  }

  /// Adds a connector; a deck that stands for more of them, or for more names of theirs, than fit
  /// into memory is refused.
  void add(Connector connector, const Element& element, const Section& section,
           const Instance* instance) {
    constexpr std::size_t kMostConnectors = 100'000;
    constexpr std::size_t kMostMegabytes = 150;
    // Each is in the element and in the connector.
    constexpr std::size_t kNode = 80;
    for (const std::string& label : connector.labels) names_ += 2 * (kNode + label.size());
    if (model_.connectors.size() == kMostConnectors || names_ > kMostMegabytes * 1'000'000) {
      if (!too_many_) {
        deck_.error(element.where, *section.block,
                    fmt::format("there are more than {} connectors, or names of them in sets for "
                                "more than {} MB",
                                kMostConnectors, kMostMegabytes));
      }
      too_many_ = true;
      return;
    }
    std::array<Ends, 2> ends;
    for (std::size_t i = 0; i < 2; ++i) {
      ends[i] = {node_of(element, element.nodes[i]), instance};
      if (const std::size_t dot = element.nodes[i].rfind('.'); dot != std::string_view::npos) {
        const auto other = instance_of_.find(label_of(element.nodes[i].substr(0, dot)));
        if (other != instance_of_.end()) ends[i].instance = &instances_[other->second];
      }
      if (ends[i].node) nodes_.try_emplace(*ends[i].node);
    }
    const auto axes = axes_.find({section.part, section.orientations[0]});
    std::optional<Matrix3d> own;
    if (section.orientations[0].empty()) {
      own = Matrix3d::Identity();
    } else if (axes != axes_.end()) {
      own = axes->second;
    }
    if (own && instance != nullptr) own = instance->turn * *own;
    connector.turned =
        !section.orientations[1].empty() && section.orientations[1] != section.orientations[0];
    model_.connectors.push_back(std::move(connector));
    places_.push_back({ends, own});
  }

  /// The node of an element's end; nothing for the ground.
  std::optional<NodeName> node_of(const Element& element, std::string_view item) const {
    const std::size_t dot = item.rfind('.');
    if (dot == item.npos) {
      const long number = deck_.whole(item, -1);
      if (item.empty() || number < 1) return std::nullopt;
      return NodeName{element.part, number};
    }
    const auto instance = instance_of_.find(label_of(item.substr(0, dot)));
    if (instance == instance_of_.end()) return std::nullopt;
    return NodeName{instances_[instance->second].part, deck_.whole(item.substr(dot + 1), -1)};
  }

  /// Reads the coordinates of the connectors' nodes, and no others: decks have millions.
  void find_positions() {
    for (const auto& [part, block] : node_blocks_) {
      if (!block->value_of("SYSTEM").empty() || block->has("INPUT")) continue;
      deck_.for_each_line(*block, [&, &part = part, block = block](std::string_view line) {
        long number = 0;
        const auto [end, fault] = std::from_chars(line.data(), line.data() + line.size(), number);
        if (fault != std::errc()) return;
        const auto node = nodes_.find({part, number});
        if (node == nodes_.end()) return;
        const Items items = split_items(line);
        Vector3d place = Vector3d::Zero();
        for (std::size_t i = 1; i < std::min<std::size_t>(4, items.size()); ++i) {
          if (items[i].empty()) continue;
          const auto coordinate = deck_.number(items[i]);
          if (!coordinate) deck_.error(items[i], *block, coordinate.error());
          place[static_cast<Eigen::Index>(i) - 1] = coordinate.value_or(0.0);
        }
        node->second = place;
      });
    }
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const auto& [ends, axes] = places_[i];
      std::array<Vector3d, 2> points;
      bool known = axes.has_value();
      for (std::size_t k = 0; k < 2; ++k) {
        const auto node = ends[k].node ? nodes_.find(*ends[k].node) : nodes_.end();
        if (node == nodes_.end() || !node->second) {
          known = false;
          continue;
        }
        points[k] = *node->second;
        if (ends[k].instance != nullptr) {
          points[k] = ends[k].instance->turn * points[k] + ends[k].instance->shift;
        }
      }
      if (!known) continue;
      const Vector3d way = points[1] - points[0];
      const bool plain = *axes == Matrix3d::Identity();
      const Vector3d seen = plain ? way : Vector3d(axes->transpose() * way);
      Point& position = model_.connectors[i].position.emplace();
      for (std::size_t k = 0; k < 3; ++k) {
        const double own = seen[static_cast<Eigen::Index>(k)];
        position[k] = plain ? own : rounded(own, way.norm());
      }
    }
  }

  struct Ends {
    std::optional<NodeName> node;
    const Instance* instance = nullptr;
  };
  struct Place {
    std::array<Ends, 2> ends;
    std::optional<Matrix3d> axes;  ///< of node a
  };
  static constexpr std::size_t kHead = 4;  ///< numbers of a periodic amplitude's first line
  using Scoped = std::pair<std::string, std::string>;  ///< part, label

  const KeywordDeck& deck_;
  Model model_;
  std::string part_;
  ElementSets sets_;
  std::vector<Instance> instances_;
  std::map<std::string, std::size_t> instance_of_;  ///< label
  std::vector<Element> elements_;
  std::vector<Section> sections_;
  std::map<Scoped, std::size_t> section_of_set_;
  std::map<std::string, std::size_t, std::less<>> behaviors_;  ///< by label
  std::map<Scoped, Matrix3d> axes_;
  std::vector<std::pair<std::string, const Block*>> node_blocks_;
  std::map<NodeName, std::optional<Vector3d>> nodes_;
  std::vector<Place> places_;
  std::optional<Step> step_;
  const Block* step_block_ = nullptr;
  std::vector<const Block*> changes_;  ///< those of the step
  std::set<std::string> held_;         ///< nodes whose motion is held in all six components
  bool others_ = false;                ///< elements that are no connectors
  std::size_t names_ = 0;              ///< bytes that names of connectors, in sets, take
  bool too_many_ = false;
  bool has_time_ = false;
  bool change_open_ = false;
  int steps_ = 0;
};

}  // namespace

Model read_model(const KeywordDeck& deck) { return Reader(deck).read(); }

const Amplitude* find_amplitude(const Model& model, const std::string& label) {
  const auto found = model.amplitudes.find(label);
  return found == model.amplitudes.end() ? nullptr : &found->second;
}

}  // namespace slipbench::driver::abaqus
