// SPDX-License-Identifier: Apache-2.0
// An experiment of a fit: its case, its data, and what of both is compared.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/csv/csv_reader.hpp"
#include "driver/calibrate/read_fit.hpp"
#include "driver/calibrate/resolve_varied.hpp"
#include "driver/read/read_case.hpp"

namespace slipbench::driver::calibrate {

/// Reads the experiments of one fit; a case that several of them name is parsed once.
class ExperimentReader {
 public:
  /// \param out everything there is to say of the cases is added to it
  /// \param varied parameters of the fit, whose starts the cases are read at
  ExperimentReader(yaml::Binder& binder, const ReadFitOptions& options,
                   std::span<const VariedParameter> varied, ReadFit& out)
      : binder_(binder), options_(options), varied_(varied), out_(out) {}

  ReadExperiment read(const ExperimentText& text, const yaml::Node& node);

 private:
  using Parsed = std::optional<read::ParsedCase>;

  /// The case of a file; nothing if it cannot be parsed, which is reported once.
  const Parsed& parse(const yaml::At<std::string>& name, const std::filesystem::path& file);
  void read_case_file(const ExperimentText& text, ReadExperiment& result);
  void read_settings(const ExperimentText& text, ReadExperiment& result);
  void read_data(const ExperimentText& text, ExperimentFit& fit);
  void read_responses(const ExperimentText& text, ReadExperiment& result);
  void read_cleaning(const ExperimentText& text, const ReadExperiment& known, ExperimentFit& fit);
  const base::CsvReader* data() const { return data_ ? &*data_ : nullptr; }
  /// Adds what is said of a case, once.
  void pass_on(const base::Diagnostics& diagnostics);

  yaml::Binder& binder_;
  const ReadFitOptions& options_;
  std::span<const VariedParameter> varied_;
  ReadFit& out_;
  std::map<std::string, Parsed> parsed_;
  std::set<std::filesystem::path> flooding_;  ///< cases with more errors than are kept: read once
  std::optional<base::CsvReader> data_;  ///< header of the experiment that is read, if it has one
};

}  // namespace slipbench::driver::calibrate
