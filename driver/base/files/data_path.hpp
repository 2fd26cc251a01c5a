// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <tl/expected.hpp>

#include "driver/base/text/history_error.hpp"

namespace slipbench::driver::base {

/// Tells whether `path` is `folder` or lies in it; both without links and dots.
bool lies_in(const std::filesystem::path& path, const std::filesystem::path& folder);

/// Returns where a file that a case names is: `text` relative to `case_folder`, the folder of the
/// case.
///
/// A case may come from anywhere, so it may name files of its own folder only. Errors of the kind
/// kInput: an empty text; a `~` or an address (`file://...`), which are never expanded; and, unless
/// `allow_outside` is set, an absolute path, a `..` anywhere, a link that leads out of the folder.
/// Of the kind kEnvironment: a path that cannot be followed (a circle of links, a folder that may
/// not be entered). Whether the file exists is for its reader to find out.
tl::expected<std::filesystem::path, HistoryError> resolve_data_path(
    const std::filesystem::path& case_folder, std::string_view text, bool allow_outside = false);

/// Returns where a file or folder is that comes with the program, such as "plots/friction.gp":
/// under share/slipbench of the installation, else, for a program or a module that was not
/// installed, in the source folder; nothing if it is in neither.
std::optional<std::filesystem::path> shipped_path(const std::filesystem::path& name);

}  // namespace slipbench::driver::base
