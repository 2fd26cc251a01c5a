// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string_view>

namespace slipbench::law {

/// Exponents of a physical dimension [F^force L^length T^time]; radians count as 1.
struct Dimension {
  int force = 0;
  int length = 0;
  int time = 0;
  friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
};

namespace dimension {
inline constexpr Dimension kNone{};
inline constexpr Dimension kForce{1, 0, 0};
inline constexpr Dimension kLength{0, 1, 0};
inline constexpr Dimension kTime{0, 0, 1};
inline constexpr Dimension kMoment{1, 1, 0};
}  // namespace dimension

/// The admissible range of a parameter.
struct Bounds {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_open = false;  ///< true: the lower bound itself is not admissible
  bool upper_open = false;

  constexpr bool contains(double x) const {
    return (lower_open ? x > lower : x >= lower) && (upper_open ? x < upper : x <= upper);
  }
};

inline constexpr Bounds kAnyNumber{};
inline constexpr Bounds kNotNegative{.lower = 0.0};
inline constexpr Bounds kPositive{.lower = 0.0, .lower_open = true};

/// The one declaration of a parameter: from it come the reader, its checks, the JSON Schema, the
/// user guide's table and `slipbench describe`.
///
/// A slip-space-dependent dimension (force or moment, length or angle) is written as for a
/// translation; `text` says so where it matters.
template <class Struct, class Member>
struct Field {
  std::string_view key;  ///< the YAML key
  Member Struct::*member;
  Dimension dimension;
  Bounds bounds;
  bool required = false;  ///< false: the brace default of the struct holds
  std::string_view text;  ///< one sentence: symbol, meaning
};

/// A sentence on what a user may not expect of a number that is given; without a key there is none.
struct Remark {
  std::string_view key;
  std::string_view text;
};

template <class Struct, class Member>
Field(std::string_view, Member Struct::*, Dimension, Bounds, bool, std::string_view)
    -> Field<Struct, Member>;

/// A Field of other pieces does not compile, and the compiler's first error says what it is made
/// of.
template <class Struct, class Member>
void take_field(std::string_view, Member Struct::*, Dimension, Bounds, bool, std::string_view);
template <class... Piece>
concept NoField = sizeof...(Piece) > 0 && !requires(const Piece&... piece) {
  take_field(piece...);
};
template <class... Piece>
struct WrongPieces {
  static_assert(!NoField<Piece...>,
                "a Field lacks a piece, or one has another type: Field{\"key\", &Law::number, "
                "dimension, bounds, true (required) or false, \"One sentence.\"}");
  using Member = int;
};
template <class... Piece>
requires NoField<Piece...> Field(Piece...)
->Field<WrongPieces<Piece...>, typename WrongPieces<Piece...>::Member>;

}  // namespace slipbench::law
