// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tests/architecture/source_file.hpp"

namespace slipbench::architecture {

/// law/ builds no strings, writes nothing and throws nothing (comments may speak of it).
std::vector<Violation> law_violations(const SourceFile& file);

/// Nothing reads the clock on the wall, which may go back: neither a result nor a time that is
/// shown depends on it.
std::vector<Violation> clock_violations(const SourceFile& file);

/// Plot templates read result files: they name no case and run no other program.
std::vector<Violation> plot_violations(const SourceFile& file);

/// Test cases stand in files *_test.cpp, which ctest runs; in another file they would never be run.
std::vector<Violation> test_case_violations(const SourceFile& file);

/// The comment of a function begins with a verb, that of a type with a noun: not with a question.
std::vector<Violation> comment_violations(const SourceFile& file);

/// C++, CMake, shell and Python sources carry the licence in their first line (after a #! line).
std::vector<Violation> licence_violations(const SourceFile& file);

/// The project stands alone: no file names a home folder or `checkout`, the folder that this very
/// checkout lies in, and no relative path in documents, scripts and build files climbs above the
/// root. (C++ tests and cases hold hostile paths on purpose: the last rule is not for them.)
std::vector<Violation> outside_violations(const SourceFile& file, const std::string& checkout);

}  // namespace slipbench::architecture
