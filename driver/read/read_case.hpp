// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "driver/base/text/source_text.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/case/case.hpp"
#include "driver/yaml/formula.hpp"
#include "driver/yaml/node.hpp"

namespace slipbench::driver::read {

struct CaseText;

/// Result of reading a case: the case, unless there were errors, and all messages.
struct ReadCase {
  std::optional<cases::Case> value;
  base::Diagnostics diagnostics;
  std::vector<std::string> data_files;    ///< that the case names, also one with errors
  std::vector<base::SourceText> sources;  ///< texts the diagnostics quote from
  bool environment_failure =
      false;  ///< some error is the machine's (exit 4), not the text's (exit 2)
};

struct ReadOptions {
  std::vector<base::ParameterText> overrides = {};  ///< --set name=value
  bool allow_outside = false;          ///< data files may lie outside the case's folder
  bool curves_may_be_missing = false;  ///< reference curves are about to be made
  /// Data may be standard input. Nobody who has a folder searched means to feed a case in it, and
  /// one that waits for an open pipe never ends.
  bool standard_input = true;
  /// Gets the formulas of the text, those of its parameters left out; or null.
  std::vector<yaml::Formula>* formulas = nullptr;
  /// Gets what is written under the keys, expressions evaluated; or null. Its nodes are of the
  /// parsed case.
  CaseText* text = nullptr;
};

/// The text of a case, parsed once, to be resolved again and again with other parameters.
class ParsedCase {
 public:
  /// Data files are looked for in `folder`. Errors: those of the text itself.
  static tl::expected<ParsedCase, base::Diagnostics> parse(const base::SourceText& source,
                                                           std::string folder);

  /// Returns the text of the case, for searches for names in it.
  yaml::Node root() const { return tree_.root(); }

  /// The case. All errors are collected.
  ReadCase resolve(const ReadOptions& options = {}) const;

  /// Only its friction definitions: history, output and checks are not looked at, so that it takes
  /// a fraction of the time. Errors of the rest.
  tl::expected<std::vector<cases::CaseDefinition>, base::Diagnostics> resolve_friction_only(
      const ReadOptions& options = {}) const;

  /// Only its parameters. Errors of those.
  tl::expected<base::NamedNumbers, base::Diagnostics> resolve_parameters_only(
      const ReadOptions& options = {}) const;

 private:
  ParsedCase(yaml::Tree tree, std::string folder)
      : tree_(std::move(tree)), folder_(std::move(folder)) {}

  yaml::Tree tree_;
  std::string folder_;
};

/// Reads, binds and checks a case file; "-" is standard input. All errors of it are collected.
ReadCase read_case(const std::string& path, const ReadOptions& options = {});

/// The same from a text in memory; data files are looked for in `folder`.
ReadCase read_case_text(const base::SourceText& source, const std::string& folder,
                        const ReadOptions& options = {});

}  // namespace slipbench::driver::read
