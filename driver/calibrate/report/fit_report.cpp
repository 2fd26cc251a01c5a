// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/report/fit_report.hpp"

#include <vector>

#include "driver/base/files/output_file.hpp"
#include "driver/report/page.hpp"

namespace slipbench::driver::calibrate {

tl::expected<std::size_t, std::string> write_fit_report(const Fit& fit,
                                                        const Calibration& calibration,
                                                        const std::filesystem::path& file,
                                                        const base::Overwriting& overwriting,
                                                        std::span<base::OutputFile* const> with) {
  const std::string source = std::filesystem::path(fit.file).filename().string();
  auto out = base::OutputFile::create(file, report::fit_page_mark(source), overwriting);
  if (!out) return tl::unexpected(out.error());
  const std::string page = report::fit_page(fit_document(fit, calibration),
                                            fit.title.empty() ? fit.file : fit.title, source);
  out->append(page);
  std::vector<base::OutputFile*> together(with.begin(), with.end());
  together.push_back(&*out);
  if (auto committed = base::commit(together); !committed) return tl::unexpected(committed.error());
  return page.size();
}

}  // namespace slipbench::driver::calibrate
