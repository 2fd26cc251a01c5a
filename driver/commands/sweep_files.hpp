// SPDX-License-Identifier: Apache-2.0
// What the commands that run and join sweeps share: what goes in, and the result.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "driver/base/files/output_file.hpp"
#include "driver/sweep/part.hpp"
#include "driver/sweep/run_sweep.hpp"
#include "driver/sweep/sweep.hpp"
#include "driver/sweep/tally.hpp"
#include "driver/table/table_writer.hpp"

namespace slipbench::driver::commands {

/// A sweep that was read, and what its journals and results are known by.
struct OpenSweep {
  sweep::Sweep sweep;
  std::vector<std::string> inputs;  ///< its files, the sweep and its case among them
  std::string identity;
};

/// Reads a sweep; where it cannot, says why and returns the exit code.
tl::expected<OpenSweep, int> open_sweep(const std::string& file,
                                        const std::vector<std::string>& settings,
                                        bool allow_outside);

struct SweepResultOptions {
  std::filesystem::path folder;
  std::optional<sweep::Part> part = std::nullopt;  ///< of the samples; nothing: all
  std::string format = "csv";                      ///< of the rows: a word of kTableFormats
  std::filesystem::path report = {};               ///< the page; none if empty
  bool no_rows = false;                            ///< only the summaries
  bool no_output = false;                          ///< only the summary
  bool force = false;
};

/// Result of a sweep, which takes sample by sample in the order of their ids: the file of the rows,
/// and what is told of them, as text, JSON and page. A part has no Sobol' indices.
class SweepResult {
 public:
  /// Errors are sentences. `open` must outlive it.
  static tl::expected<std::unique_ptr<SweepResult>, std::string> create(
      const OpenSweep& open, const SweepResultOptions& options);

  /// "name", or "name.2of8": what the files are called.
  const std::string& name() const { return name_; }

  void take(const sweep::SampleOutcome& outcome);
  /// Takes all samples at once, where no rows are written.
  void take(sweep::Tally tally) { tally_ = std::move(tally); }

  /// Completes the files and says what was found.
  /// \param how they came, beside their number: "0.42 s"
  /// \param also another file that was written, to be named; or nothing
  /// \return the exit code
  int finish(const std::string& how, const std::filesystem::path& also = {});

 private:
  SweepResult(const OpenSweep& open, std::string name) : open_(&open), name_(std::move(name)) {}

  const OpenSweep* open_;
  std::string name_;
  std::optional<base::OutputFile> file_;
  std::optional<table::TableWriter> rows_;  ///< to `file_`
  std::vector<double> row_;
  std::optional<base::OutputFile> indices_file_, summary_file_, page_file_;
  sweep::Tally tally_{open_->sweep};
};

}  // namespace slipbench::driver::commands
