// SPDX-License-Identifier: Apache-2.0
// One line of numbers of a starter deck, in fixed columns.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/units/expression.hpp"

namespace slipbench::driver::radioss {

/// A field of a line: `width` columns from column `begin` (from 0). Reals have 20 columns, integers
/// 10; one without a name must be blank.
struct DeckField {
  std::size_t begin = 0;
  std::size_t width = 10;
  std::string_view name;
  bool integer = false;
};

/// The numbers of a line, one for each field that has a name.
struct DeckNumbers {
  std::vector<double> values;
  std::vector<std::string_view> texts;  ///< where each stands in the line; empty: not written
  bool free_format = false;             ///< the fields did not stand in their columns
};

/// Fault of a line: a sentence, and the part of the line it speaks of.
struct DeckFault {
  std::string message;
  std::string_view text;
};

using base::shortened;

/// Reads a number as Fortran does: "1.5", "1.", ".5", "1.0D-3", and "1-3" for 1e-3. Errors: any
/// other character; a number no double can hold.
tl::expected<double, std::string> parse_fortran_number(std::string_view text);

/// Reads a line by its columns: blanks around a number do not matter, an empty field is 0, and so
/// are all that a short line lacks. A line that cannot be read so, but splits at blanks into as
/// many numbers as there are named fields (or `least_free`, if the last may be missing), counts as
/// free format. `&name` is a number of `parameters`. Errors: a text that is no number; a name that
/// is no parameter; a fraction where an integer is wanted.
tl::expected<DeckNumbers, DeckFault> read_numbers(std::string_view line,
                                                  std::span<const DeckField> fields,
                                                  std::size_t least_free,
                                                  const base::NamedNumbers& parameters = {});

/// Reads one field of a line by its columns, whatever stands in the others.
tl::expected<double, DeckFault> read_field(std::string_view line, const DeckField& field,
                                           const base::NamedNumbers& parameters);

}  // namespace slipbench::driver::radioss
