// SPDX-License-Identifier: Apache-2.0
#include "driver/import/contact/contact_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/base/text/json.hpp"

namespace slipbench::driver::import {
namespace {

constexpr std::size_t kWidth = 96;

/// A list that breaks into lines behind `indent` blanks.
std::string list_text(const std::vector<int>& numbers, std::size_t indent) {
  std::string text = "[";
  std::size_t column = indent;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string one = std::to_string(numbers[i]) + (i + 1 < numbers.size() ? "," : "");
    if (column + one.size() > kWidth) {
      text += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (i > 0) {
      text += " ";
      ++column;
    }
    text += one;
    column += one.size();
  }
  return text + "]";
}

std::string limit_text(double stress) {
  return fmt::format("force_limit: = {}*area", base::format_number(stress));
}

class ContactText {
 public:
  explicit ContactText(const ContactFriction& friction)
      : friction_(friction), table_(!friction.pairs.empty()) {
    for (const ContactRecord& pair : friction.pairs) {
      orthotropic_ = orthotropic_ || !pair.second.empty();
    }
  }

  WrittenCase write() {
    heading();
    parameters();
    connector();
    if (table_) table();
    definition();
    history();
    out_.losses = friction_.losses;
    const auto kept = [&](std::string what) {
      out_.losses.push_back({Loss::Kind::kKept, std::move(what)});
    };
    const std::string& coefficient = friction_.otherwise.coefficient;
    const bool is_table = coefficient.find("columns:") != coefficient.npos;
    kept(friction_.name + ": coefficient " + (is_table ? "as a table" : coefficient));
    if (table_)
      kept(fmt::format("{} record{} of part pairs", friction_.pairs.size(),
                       friction_.pairs.size() == 1 ? "" : "s"));
    if (!friction_.filter.empty()) kept("filter " + friction_.filter);
    for (const std::string& note : friction_.notes) kept(note);
    out_.notes = friction_.notes;
    out_.losses.push_back({Loss::Kind::kDropped, "mesh and all that is no friction of a contact"});
    return std::move(out_);
  }

 private:
  template <class... Argument>
  void line(fmt::format_string<Argument...> text, Argument&&... arguments) {
    out_.text += fmt::format(text, std::forward<Argument>(arguments)...) + "\n";
  }

  void heading() {
    line("# {} of {}, written by slipbench import{}", friction_.name,
         base::printable(friction_.deck), friction_.title.empty() ? "" : ": " + friction_.title);
    for (const std::string& note : friction_.notes) line("# {}", base::printable(note));
    for (const Loss& loss : friction_.losses) {
      if (loss.kind != Loss::Kind::kKept) line("# {}", base::printable(loss.text));
    }
    line("# The deck has no values for the parameters below: give each one here, or with --set.");
    line("slipbench: 1");
    line("title: {}",
         base::json::Value(friction_.title.empty() ? friction_.name : friction_.title).dump());
    if (friction_.units) {
      line("units: {{length: {}, force: {}, time: {}}}", friction_.units->length,
           friction_.units->force, friction_.units->time);
    } else {
      line("# State the units the deck is in{}:",
           friction_.needs_units ? "; the law does not run without" : "");
      line("# units: {{length: mm, force: N, time: s}}");
    }
    line("");
  }

  void parameter(std::string_view name, std::string_view text) {
    line("  {:<16}# {}", std::string(name) + ":", text);
    out_.asked.emplace_back(name);
  }

  void parameters() {
    line("parameters:");
    if (table_) {
      parameter("part1", "id of the part on one side of the contact");
      parameter("part2", "id of the part on the other side");
    }
    if (friction_.sees_pressure) {
      parameter("area", "of the contact; the solver divides the force by that of one segment");
    }
    if (friction_.viscous) {
      parameter("K", "stiffness of the normal penalty, as the solver's listing gives it");
      parameter("m", "mass of the secondary node");
    } else if (!friction_.tangential_stiffness) {
      parameter("K_t", "tangential stiffness of the contact");
    }
    parameter("normal_force", "what presses the contact");
    parameter("speed", "at which it slides");
    parameter("time_step", "of the solver's run");
    line("");
  }

  void connector() {
    line("connector:");
    line("  type: CONTACT");
    if (friction_.sees_pressure) line("  area: = area");
    if (table_) line("  parts: [= part1, = part2]");
    line("");
  }

  /// The keys of a record, each behind `indent` blanks.
  void record(const ContactRecord& one, std::size_t indent) {
    const std::string blanks(indent, ' ');
    if (one.second.empty()) {
      line("{}coefficient: {}", blanks, one.coefficient);
    } else {
      line("{0}coefficient:\n{0}  orthotropic:\n{0}    direction1: {1}\n{0}    direction2: {2}",
           blanks, one.coefficient, one.second);
    }
    if (one.visf != 0.0) line("{}VISF: {}", blanks, base::format_number(one.visf));
    if (one.shear_limit > 0.0) line("{}{}", blanks, limit_text(one.shear_limit));
  }

  void table() {
    line("friction_pairs:");
    // Without all of the deck's parts a list would refuse good ids.
    if (!friction_.parts.empty()) line("  parts: {}", list_text(friction_.parts, 10));
    if (!friction_.groups.empty()) line("  groups:");
    for (const auto& group : friction_.groups) {
      if (!group->title.empty()) line("    # {}", group->title);
      if (group->parts.empty()) {
        line("    {}: []    # {}", group->name, kPartsToFillIn);
      } else {
        line("    {}: {}", group->name, list_text(group->parts, 7 + group->name.size()));
      }
    }
    line("  default:");
    record(friction_.otherwise, 4);
    line("  pairs:    # the last record that joins both parts holds");
    for (const ContactRecord& pair : friction_.pairs) {
      line("    - parts: [{}, {}]    # {}", pair.sides[0], pair.sides[1], pair.remark);
      record(pair, 6);
    }
    line("");
  }

  void definition() {
    line("friction:");
    line("  - predefined: {{}}");
    if (!table_) {
      line("    coefficient: {}", friction_.otherwise.coefficient);
      if (friction_.otherwise.shear_limit > 0.0) {
        line("    {}", limit_text(friction_.otherwise.shear_limit));
      }
    }
    for (const std::string& remark : friction_.remarks) line("    # {}", remark);
    if (friction_.viscous) {
      const double visf = table_ ? 0.0 : friction_.otherwise.visf;
      line("    formulation: {{penalty: viscous{}, K: = K, m: = m{}}}",
           visf == 0.0 ? "" : ", VISF: " + base::format_number(visf),
           friction_.as_coded ? ", convention: as_coded" : "");
    } else {
      line("    formulation: {{penalty: stiffness, K_t: {}}}",
           friction_.tangential_stiffness ? base::format_number(*friction_.tangential_stiffness)
                                          : "= K_t");
    }
    if (!friction_.filter.empty()) line("    filter: {}", friction_.filter);
    if (orthotropic_) {
      line(
          "    # Direction 1 of the orthotropic records is component 2 of this contact (CP2, f2).");
      for (const std::string& remark : friction_.orientation) line("    # {}", remark);
    }
    line("");
  }

  void history() {
    line("history:");
    line("  - step: slide");
    line("    duration: = 1000*time_step");
    line("    increments: 1000");
    line("    force: {{f1: = normal_force}}");
    if (orthotropic_) {
      line("    # at 45 degrees to both directions");
      line(
          "    motion: {{CP2: {{to: = 1000*time_step*speed/sqrt(2)}}, CP3: {{to: = "
          "1000*time_step*speed/sqrt(2)}}}}");
    } else {
      line("    motion: {{CP2: {{to: = 1000*time_step*speed}}}}");
    }
    if (!friction_.checks.empty()) line("\n{}", friction_.checks);
    // One line's end is that of the text.
    if (out_.text.ends_with("\n\n")) out_.text.pop_back();
  }

  const ContactFriction& friction_;
  bool table_ = false;
  bool orthotropic_ = false;
  WrittenCase out_;
};

}  // namespace

WrittenCase contact_case(const ContactFriction& friction) { return ContactText(friction).write(); }

}  // namespace slipbench::driver::import
