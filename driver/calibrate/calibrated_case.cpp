// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/calibrated_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <set>
#include <system_error>
#include <tl/expected.hpp>
#include <utility>
#include <variant>

#include "driver/base/files/data_path.hpp"
#include "driver/base/files/file_part.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/base/text/number.hpp"
#include "driver/base/text/source_text.hpp"
#include "driver/base/units/carried_unit.hpp"
#include "driver/calibrate/calibration_comment.hpp"
#include "driver/calibrate/table_place.hpp"
#include "driver/calibrate/text_changes.hpp"
#include "driver/calibrate/varied_case.hpp"
#include "driver/check/curves/curve_library.hpp"
#include "driver/yaml/parse.hpp"

namespace slipbench::driver::calibrate {
namespace {

namespace fs = std::filesystem;

NodeChange& change_at(NodeChange& root, const std::vector<std::size_t>& way) {
  NodeChange* change = &root;
  for (const std::size_t i : way) change = &change->children[i];
  return *change;
}

/// Fitted experiments that share a case file and its settings.
struct Group {
  std::vector<std::size_t> experiments;
};

std::vector<Group> groups_of(const Fit& fit) {
  const auto alike = [&](std::size_t a, std::size_t b) {
    const ExperimentFit& one = fit.experiments[a];
    const ExperimentFit& other = fit.experiments[b];
    return one.case_path.lexically_normal() == other.case_path.lexically_normal() &&
           std::equal(one.settings.begin(), one.settings.end(), other.settings.begin(),
                      other.settings.end(), [](const auto& p, const auto& q) {
                        return p.name == q.name && p.value == q.value;
                      });
  };
  std::vector<Group> groups;
  for (std::size_t e = 0; e < fit.experiments.size(); ++e) {
    if (fit.experiments[e].held_out) continue;
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
      return alike(group.experiments.front(), e);
    });
    if (found == groups.end()) {
      groups.push_back({{e}});
    } else {
      found->experiments.push_back(e);
    }
  }
  return groups;
}

std::vector<std::string> file_names(const Fit& fit, const std::vector<Group>& groups) {
  const auto stem = [&](const Group& group) {
    return fit.experiments[group.experiments.front()].case_path.stem().string();
  };
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const Group& group : groups) {
    std::string name = stem(group);
    const auto same = std::count_if(groups.begin(), groups.end(),
                                    [&](const Group& other) { return stem(other) == stem(group); });
    if (same > 1) {
      name += "." + base::file_part(fit.experiments[group.experiments.front()].name);
    }
    const std::string wanted = name;
    for (int n = 2; !taken.insert(name).second; ++n) name = fmt::format("{}.{}", wanted, n);
    names.push_back(name + ".calibrated.yaml");
  }
  return names;
}

/// One case that is being given its numbers.
class CaseWriter {
 public:
  CaseWriter(const Fit& fit, const Calibration& calibration, const yaml::Tree& tree,
             const ExperimentFit& experiment)
      : fit_(fit), calibration_(calibration), tree_(tree), experiment_(experiment) {}

  tl::expected<std::string, std::string> text(const std::vector<std::size_t>& experiments,
                                              const fs::path& folder) {
    set_parameters();
    for (std::size_t t = 0; t < fit_.tables.size(); ++t) {
      if (auto fault = set_table(t)) return tl::unexpected(*fault);
    }
    move_data_files(folder);
    const auto edited = with_changes(tree_, changes_);
    if (!edited) return tl::unexpected(edited.error());
    std::string comment = calibration_comment(fit_, calibration_, experiments, unknowns_);
    for (const std::string& remark : remarks_) comment += "# " + base::printable(remark) + "\n";
    for (const std::string& note : notes_) comment += "# " + base::printable(note) + "\n";
    return comment + *edited;
  }

  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  [[nodiscard]] Place root() const { return {tree_.root()}; }

  /// The new number is one of the case's system and stands bare; an expression, and a number with
  /// its unit, are kept in the comments.
  void replace(const Place& place, std::string text) {
    const std::string_view old = place.node.text();
    if (place.node.is_scalar() && (old.starts_with('=') || base::carries_unit(old))) {
      remarks_.push_back(fmt::format("{} was {}'{}'", place.path.text(),
                                     old.starts_with('=') ? "the expression " : "",
                                     std::string(old)));
    }
    change_at(changes_, place.way).text = std::move(text);
  }

  void set_parameters() {
    const auto parameters = root().find("parameters");
    if (!parameters) return;
    const std::vector<base::ParameterText>& settings = experiment_.settings;
    for (auto setting = settings.begin(); setting != settings.end(); ++setting) {
      const auto place = parameters->find(setting->name);
      const bool last = std::none_of(
          setting + 1, settings.end(),
          [&](const base::ParameterText& later) { return later.name == setting->name; });
      if (!place || !last) continue;
      std::string text;
      if (const double* number = std::get_if<double>(&setting->value)) {
        text = base::format_number(*number);
      } else {
        const std::string& written = std::get<std::string>(setting->value);
        const bool plain = written.starts_with('=') || base::parse_number(written).has_value() ||
                           base::carries_unit(written);
        text = yaml_scalar(plain ? written : "= " + written);
      }
      remarks_.push_back(
          fmt::format("set for experiment '{}': {} = {}", experiment_.name, setting->name, text));
      replace(*place, std::move(text));
    }
    for (std::size_t u = 0; u < fit_.vary.size() && u < calibration_.unknowns.size(); ++u) {
      const auto place = parameters->find(fit_.vary[u].name);
      if (!place) continue;
      replace(*place, base::format_number(calibration_.unknowns[u].value));
      unknowns_.push_back(u);
    }
  }

  [[nodiscard]] static std::size_t free_column(const Place& table, const std::string& name) {
    const yaml::Node columns = *table.node.find("columns");
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i].text() == name) return i;
    }
    return 0;
  }

  /// \return what is wrong, if something is
  std::optional<std::string> set_table(std::size_t t) {
    const VariedTable& varied = fit_.tables[t];
    const auto fitted = std::find_if(calibration_.tables.begin(), calibration_.tables.end(),
                                     [&](const FittedTable& table) { return table.index == t; });
    if (fitted == calibration_.tables.end()) return std::nullopt;
    std::set<std::vector<std::size_t>> done;  // sliding and spinning may share one table
    for (const std::size_t i : definitions_with(experiment_.base, varied)) {
      const auto found = table_place(tree_.root(), experiment_.base, i, varied.use);
      if (!found || !found->node.find("columns") || !done.insert(found->way).second) continue;
      const Place& place = *found;
      if (const auto rows = place.find("rows")) {
        if (!set_rows(*rows, free_column(place, varied.free), *fitted)) {
          return fmt::format("the rows of table '{}' are not those that were fitted", varied.name);
        }
      } else if (const auto csv = place.find("csv")) {
        write_rows(*csv, *fitted);
      }
    }
    if (done.empty()) return std::nullopt;
    for (std::size_t i = 0; i < fitted->count; ++i) unknowns_.push_back(fitted->first_unknown + i);
    return std::nullopt;
  }

  [[nodiscard]] double ordinate(const FittedTable& table, std::size_t row) const {
    return calibration_.unknowns[table.first_unknown + row].value;
  }

  bool set_rows(const Place& rows, std::size_t column, const FittedTable& table) {
    if (rows.node.size() != table.count) return false;
    for (std::size_t r = 0; r < table.count; ++r) {
      const Place row = rows.at(r);
      if (row.node.size() <= column) return false;
      replace(row.at(column), base::format_number(ordinate(table, r)));
    }
    return true;
  }

  /// The name of a data source's file.
  static Place file_in(const Place& source) {
    const auto file = source.node.is_map() ? source.find("file") : std::nullopt;
    return file ? *file : source;
  }

  /// A table from a file becomes rows: the case is then complete in itself.
  void write_rows(const Place& csv, const FittedTable& table) {
    Place parent = root();
    for (std::size_t i = 0; i + 1 < csv.way.size(); ++i) parent = parent.at(csv.way[i]);
    const yaml::Node key = parent.node.entry(csv.way.back()).key;
    // Lines of a flow list have to be indented deeper than the key.
    const std::string feed =
        ",\n" + std::string(static_cast<std::size_t>(key.where().column) + 7, ' ');
    std::string text = "[";
    for (std::size_t r = 0; r < table.count; ++r) {
      text += (r > 0 ? feed : "") + "[" + base::format_number(ordinate(table, r));
      for (const double x : table.points[r]) text += ", " + base::format_number(x);
      text += "]";
    }
    remarks_.push_back(fmt::format("{} was the file '{}'", csv.path.text(),
                                   std::string(file_in(csv).node.text())));
    NodeChange& change = change_at(changes_, csv.way);
    change.key = "rows";
    change.text = text + "]";
    became_rows_.insert(csv.way);
  }

  /// Paths of data files, from where the calibrated case is going to be.
  void move_data_files(const fs::path& folder) {
    std::error_code failure;
    const fs::path from = fs::weakly_canonical(fs::absolute(experiment_.case_path), failure);
    const fs::path old_folder = from.parent_path();
    new_folder_ = fs::weakly_canonical(fs::absolute(folder.empty() ? "." : folder), failure);
    for (std::size_t i = 0; i < tree_.root().size(); ++i) {
      if (tree_.root().entry(i).key.text() == "parameters") continue;
      move_below(root().at(i), old_folder);
    }
    if (outside_) {
      notes_.push_back("reads data files from outside its folder: run it with --allow-outside");
    }
  }

  void move_below(const Place& place, const fs::path& old_folder) {
    for (std::size_t i = 0; i < place.node.size(); ++i) {
      const Place source = place.at(i);
      const std::string_view key = place.node.is_map() ? place.node.entry(i).key.text() : "";
      const bool is_source = key == "csv" || key == "curve";
      const Place below = is_source ? file_in(source) : source;
      if (!is_source || !below.node.is_scalar()) {
        move_below(source, old_folder);
        continue;
      }
      const std::string_view file = below.node.text();
      if (file == "-" || (key == "curve" && check::is_curve_name(file))) continue;
      if (became_rows_.contains(source.way)) continue;
      const fs::path written(file);
      std::string now(file);
      if (!written.is_absolute() && old_folder != new_folder_) {
        now = (old_folder / written).lexically_normal().lexically_relative(new_folder_).string();
      }
      if (now != file) change_at(changes_, below.way).text = yaml_scalar(now, below.node.quoted());
      outside_ = outside_ || !base::resolve_data_path(new_folder_, now);
    }
  }

  const Fit& fit_;
  const Calibration& calibration_;
  const yaml::Tree& tree_;
  const ExperimentFit& experiment_;
  NodeChange changes_;
  std::vector<std::size_t> unknowns_;  ///< that the case has
  std::vector<std::string> remarks_;
  std::vector<std::string> notes_;
  std::set<std::vector<std::size_t>> became_rows_;  ///< ways to `csv:`
  fs::path new_folder_;
  bool outside_ = false;
};

/// Tells whether the first line of a file ends in CRLF, and so all of them, usually.
bool has_windows_line_ends(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string line;
  return std::getline(in, line) && !in.eof() && line.ends_with('\r');
}

std::string with_windows_line_ends(const std::string& text) {
  std::string out;
  out.reserve(text.size() + text.size() / 16);
  for (const char c : text) {
    if (c == '\n') out += '\r';
    out += c;
  }
  return out;
}

}  // namespace

base::FileMark calibrated_case_mark(const Fit& fit) {
  const std::string name = fs::path(fit.file).filename().string();
  return {.owner = "an unchanged case calibrated by " + name,
          .start = "# Calibrated by slipbench ",
          .text = "\n# fit: " + base::printable(name),
          .sealed = true};
}

std::vector<std::string> calibrated_case_names(const Fit& fit) {
  return file_names(fit, groups_of(fit));
}

CalibratedCases calibrated_cases(const Fit& fit, const Calibration& calibration,
                                 const fs::path& folder) {
  CalibratedCases result;
  const std::vector<Group> groups = groups_of(fit);
  const std::vector<std::string> names = file_names(fit, groups);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const ExperimentFit& experiment = fit.experiments[groups[g].experiments.front()];
    const auto fault = [&](const std::string& sentence) {
      result.faults.push_back(
          fmt::format("{}: no calibrated case: {}", experiment.case_file, sentence));
    };
    const auto source = base::read_source(experiment.case_path.string());
    if (!source) {
      fault(source.error().diagnostic.message);
      continue;
    }
    const auto tree = yaml::parse_yaml(*source);
    if (!tree) {
      fault("its text is no longer what it was");
      continue;
    }
    CaseWriter writer(fit, calibration, *tree, experiment);
    auto text = writer.text(groups[g].experiments, folder);
    if (!text) {
      fault(text.error());
      continue;
    }
    if (has_windows_line_ends(experiment.case_path)) *text = with_windows_line_ends(*text);
    result.cases.push_back({names[g], std::move(*text), groups[g].experiments, writer.notes()});
  }
  return result;
}

}  // namespace slipbench::driver::calibrate
