// SPDX-License-Identifier: Apache-2.0
// From a tree to structs: every key of a case file is declared once, beside its member; reader,
// JSON Schema and the case reference all walk that declaration.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/history_error.hpp"
#include "driver/base/text/json.hpp"
#include "driver/base/units/expression.hpp"
#include "driver/base/units/unit_dimension.hpp"
#include "driver/yaml/formula.hpp"
#include "driver/yaml/node.hpp"
#include "law/base/field.hpp"
#include "law/base/unit_name.hpp"
#include "law/table/table.hpp"

namespace slipbench::driver::yaml {

using Json = base::json::Value;

/// Units that a number may carry: "12 mm" is converted to the case's system.
enum class UnitUse {
  kDeclared,  ///< of KeyInfo::dimension; none for a number without dimension
  kSlip,      ///< of KeyInfo::dimension in a translation, of that rotated() in a rotation: judged
              ///< by Binder::settle_units once it is known which
  kQuantity,  ///< of the quantity it is a value of: judged by Binder::settle_units
  kAny,       ///< any
  kNone       ///< none: it is in the case's system
};

/// A dimension as the law room declares it.
constexpr base::Dimension declared(const law::Dimension& dimension) {
  return {dimension.force, dimension.length, dimension.time};
}

/// Declaration of a key besides its type.
struct KeyInfo {
  bool required = false;
  std::string_view text = {};          ///< one sentence for the user
  std::string_view default_text = {};  ///< the default in words, if the key is optional
  base::Dimension dimension = {};
  law::Bounds bounds = {};
  UnitUse unit = UnitUse::kDeclared;
  bool difference = false;  ///< of a temperature: a difference, to which 20 degF adds no offset
  std::size_t most = 0;     ///< so many items of a list or names of a map, at most; 0: any number
};

/// One line of the case reference.
struct KeyRow {
  std::string path;    ///< friction[].stick.elastic_slip
  std::string wanted;  ///< "a number"
  KeyInfo info;
};

/// A key or word that is known by name, but that this version does not have.
struct LaterKey {
  std::string_view name;
  std::string_view why;               ///< a sentence
  std::string_view in_place_of = {};  ///< the key this version wants instead, if any
};

/// Words of messages about one kind of file on keys and names that are not known. A function that
/// has nothing to say returns an empty text, or nothing; none is null.
struct FileWords {
  std::optional<LaterKey> (*later_key)(std::string_view key);
  /// Returns what is written in place of a key, or where it belongs if that is certain.
  std::string (*other_name)(std::string_view key);
  /// Returns where in such a file a key is known.
  std::string (*places_of_key)(std::string_view key);
  /// Returns what brings a result column.
  std::string (*origin_of_column)(std::string_view name);
  /// The hint for a name in an expression that is defined nowhere.
  std::string_view undefined_name;
};

/// Reading context: where messages go and what expressions may use.
class Binder {
 public:
  /// \param unresolved parameters whose own value is faulty: expressions that use them have no
  /// value, and that is not reported again
  Binder(base::Diagnostics& out, const base::NamedNumbers& parameters,
         const std::vector<std::string>& unresolved, std::filesystem::path case_folder,
         bool allow_outside, const FileWords& words)
      : out_(out),
        words_(words),
        parameters_(parameters),
        unresolved_(unresolved.begin(), unresolved.end()),
        case_folder_(std::move(case_folder)),
        allow_outside_(allow_outside) {}

  void error(const Node& at, const Path& path, std::string message, std::string hint = {});
  void warning(const Node& at, const Path& path, std::string message, std::string hint = {});
  void note(const Node& at, const Path& path, std::string message, std::string hint = {});

  /// The system that numbers with a unit are converted to; nothing if there are several.
  void set_units(std::optional<base::UnitSystem> units) { units_ = std::move(units); }

  /// Returns how the tables of the connector's behaviour are prolonged that do not say it.
  [[nodiscard]] law::Extrapolation extrapolation() const { return extrapolation_; }
  void set_extrapolation(law::Extrapolation extrapolation) { extrapolation_ = extrapolation; }
  /// From now on writes down every formula that is read; nothing if null.
  void note_formulas(std::vector<Formula>* formulas) { formulas_ = formulas; }
  bool is_parameter(std::string_view name) const { return parameters_.contains(name); }

  /// Returns the number of a formula that is the name of a parameter, or that was evaluated before;
  /// nothing of others. An alias may repeat either in many places.
  std::optional<double> known_number(const Node& node, const Path& path);
  /// A number in the case's system: a plain scalar, one with a unit ("12 mm"), or an expression
  /// over the parameters ("= 2/li").
  /// \return nothing after reporting an error
  std::optional<double> number(const Node& node, const Path& path, const KeyInfo& info);

  /// Judges the units of the numbers read at `below` and under it, now that it is known what they
  /// measure; those of the wrong dimension are reported.
  /// \param wanted the dimension for one declared with KeyInfo::dimension
  void settle_units(const Path& below,
                    const std::function<base::Dimension(const base::Dimension&)>& wanted);
  void settle_units(const Path& below, const base::Dimension& wanted);
  /// The same for numbers declared as a translation's.
  void settle_slip_units(const Path& below, bool rotation);
  /// Reports every number whose unit was never judged.
  void refuse_unsettled_units();

  /// Tells whether the scalar is an expression (starts with '='), quoted or not.
  static bool is_expression(const Node& node);
  /// Compiles an expression; `variables` get their values at evaluation.
  std::optional<base::Expression> expression(const Node& node, const Path& path,
                                             const std::vector<std::string>& variables);
  /// Reports an expression's error at its node with the nearest known name.
  void expression_error(const Node& node, const Path& path, const base::ExpressionError& error,
                        const std::vector<std::string>& variables);

  /// Reports a key that `allowed` does not have: nearest name, or where in the file it belongs.
  /// \param hint if something is known of the key here
  /// \return the allowed key that was probably meant, or nothing
  std::optional<std::string_view> unknown_key(const Node& key, const Path& path,
                                              std::span<const std::string_view> allowed,
                                              std::string_view hint = {});
  /// The hint for an unknown name: "did you mean 'normal'?", or `otherwise` if none is near;
  /// nothing once flooded, as nobody reads it.
  [[nodiscard]] std::string nearest_or(std::string_view name,
                                       std::span<const std::string_view> names,
                                       std::string otherwise) const;
  [[nodiscard]] std::string known_functions(const std::string& name) const;
  void missing_key(const Node& map, const Path& path, std::string_view key,
                   std::string_view wanted);
  /// "wanted a number, found a list".
  void wrong_kind(const Node& node, const Path& path, std::string_view wanted);
  /// Checks how many items a list has, or names a map: "60000 items, at most 9000 are read".
  bool few_enough(const Node& items, const Path& path, std::size_t most);
  /// Checks bounds; "must not be negative (found -0.1)".
  bool in_bounds(double value, const Node& node, const Path& path, const law::Bounds& bounds);

  /// A data file the case names, inside its own folder unless the user allowed more.
  std::optional<std::filesystem::path> data_file(const Node& node, const Path& path,
                                                 std::string_view text);
  /// The same for a case, which is read more than once: not standard input.
  std::optional<std::filesystem::path> case_file(const Node& node, const Path& path,
                                                 std::string_view text);
  /// All files that were asked for so, in this order, be they there or not.
  [[nodiscard]] const std::vector<std::string>& data_files() const { return data_files_; }
  /// Reports a fault of a data file, in the file's own words and place.
  void history_error(const Node& node, const Path& path, const base::HistoryError& error,
                     std::string hint = {});
  /// Tells whether some fault was the machine's (a file that cannot be read), not the text's.
  [[nodiscard]] bool environment_failed() const { return environment_failed_; }

  /// Until the next call, unknown names in expressions are excused: they may be result columns,
  /// and which there are is not known while the friction definitions are faulty.
  void excuse_unknown_names(bool excused) { unknown_names_excused_ = excused; }
  [[nodiscard]] bool unknown_names_excused() const { return unknown_names_excused_; }

  [[nodiscard]] std::size_t errors() const { return out_.count(base::Severity::kError); }
  /// Tells whether there are so many errors that further ones are only counted: what costs time or
  /// memory for their sake can be left out.
  [[nodiscard]] bool flooded() const { return errors() > base::Diagnostics::kMaxKept; }

  /// Makes standard input an error from here on.
  void refuse_standard_input() { standard_input_refused_ = true; }

  /// Counts rows of tables that are read from files, which may name one file again and again.
  /// Returns false once they are more than all tables of a case may have.
  bool count_table_row() { return ++table_rows_ <= kMostTableRows; }
  static constexpr std::size_t kMostTableRows = 2'000'000;

  /// Counts a file of numbers that is read through while the case is. Returns false, after an error
  /// there, once the case has the same files read again and again.
  /// \param effort of reading one byte, as a multiple of the least
  bool may_read(const Node& node, const Path& path, const std::filesystem::path& file,
                std::uintmax_t effort);

  /// Tells whether a unit is another one than the case's, of some quantity that it may be of. False
  /// for what the case states no unit of.
  [[nodiscard]] bool is_foreign_unit(std::string_view unit) const;

  /// Returns the words of a key, which `make` is called for once.
  const std::string& words_of(std::string key, const std::function<std::string()>& make);

  /// Counts a formula over the time, whose compiled form stays.
  /// Returns false once they are more than a case may have.
  bool count_formula() { return ++kept_formulas_ <= kMostFormulas; }
  /// Tells whether they are: then nothing is compiled any more.
  [[nodiscard]] bool has_too_many_formulas() const { return kept_formulas_ > kMostFormulas; }
  static constexpr std::size_t kMostFormulas = 10'000;

 private:
  /// The hint for an unknown key of a case that goes by another name here, or empty.
  std::optional<double> number_with_unit(const Node& node, const Path& path, const KeyInfo& info);

  /// A number whose unit still has to be judged.
  struct UnsettledUnit {
    Node node;
    Path path;
    base::Dimension dimension;  ///< of the unit
    base::Dimension wanted;     ///< as the key declares it
  };
  base::Diagnostics& out_;
  std::optional<base::UnitSystem> units_ = base::UnitSystem{};
  law::Extrapolation extrapolation_ = law::Extrapolation::kConstant;
  std::multimap<std::string, UnsettledUnit, std::less<>> unsettled_;  ///< by their paths
  std::vector<Formula>* formulas_ = nullptr;
  FileWords words_;
  const base::NamedNumbers& parameters_;
  std::set<std::string, std::less<>> unresolved_;
  std::filesystem::path case_folder_;
  std::vector<std::string> data_files_;
  std::size_t table_rows_ = 0;
  std::size_t kept_formulas_ = 0;
  std::map<std::string, std::string> kept_words_;  ///< by keys
  std::uintmax_t read_ = 0;                        ///< bytes of files of numbers
  std::uintmax_t longest_read_ = 0;                ///< of the largest of them
  bool allow_outside_;
  bool standard_input_refused_ = false;
  bool environment_failed_ = false;
  bool unknown_names_excused_ = false;
  base::NamedNumbers evaluated_;  ///< formulas over parameters, by their texts
};

/// Bounds in words: "at least 0", "greater than 0", "between 0 and 1"; empty if any number will do.
std::string in_words(const law::Bounds& bounds);

/// The same of a key: of its number, or of how many items it has ("at most 1000").
std::string limits_in_words(const KeyInfo& info);

/// Rules by which one type is read, described in JSON Schema, and listed in the case reference:
///   static bool read(Binder&, const Node&, const Path&, const KeyInfo&, T& out);
///   static Json schema(const KeyInfo&);
///   static std::string wanted(const KeyInfo&);            // "a number"
///   static void rows(const std::string& path, std::vector<KeyRow>&);   // keys below this one
template <class T>
struct Codec;

/// A value with its place, for what can only be judged later. A faulty value is kept, so that what
/// stands beside the fault is judged in the same run: `given` says that the key was written,
/// `sound` that its value may be used.
template <class T>
struct At {
  T value{};
  std::optional<Node> node;
  Path path;
  bool sound = false;  ///< given and read without error

  [[nodiscard]] bool given() const { return node.has_value(); }
  [[nodiscard]] bool faulty() const { return given() && !sound; }
};

/// The value a key has when it is not given.
template <class T>
At<T> default_of(T value) {
  At<T> at;
  at.value = std::move(value);
  return at;
}

/// An entry of a map whose keys are the user's names; kept if its value is faulty, as in At.
template <class T>
struct Named {
  std::string name;
  std::optional<Node> key;
  std::optional<Node> node;  ///< of the value
  Path path;
  T value{};
  bool sound = false;
};
template <class T>
using NamedMap = std::vector<Named<T>>;

// ---------------------------------------------------------------------------------------------
// Structs: T::declare(visitor) calls visitor(key, &T::member, KeyInfo) for every key; a law's or a
// connection's fields() tuple serves as well.

struct AnyVisitor {
  void operator()(std::string_view key, auto member, const KeyInfo& info) const;
};
template <class T>
concept Declared = requires(const AnyVisitor& visitor) {
  T::declare(visitor);
};
template <class T>
concept HasFields = requires {
  T::fields();
};

/// Enumerations give their YAML words in the order of their values: EnumWords<E>::kWords.
template <class E>
struct EnumWords;

/// A number as a default is written; empty for 0. The text lasts as long as the program.
std::string_view default_text(double number);

/// The default of a law's or a connection's member in words; empty for 0.
template <class T, class Member>
std::string_view default_of_member(Member T::*member) {
  if constexpr (std::is_same_v<Member, double>) return default_text(T{}.*member);
  return "";
}
template <class T, class Member>
constexpr std::string_view default_of_member(std::optional<Member> T::*) {
  return "none";
}
template <class T>
constexpr std::string_view default_of_member(law::UnitName T::*) {
  return "none";
}
template <class T, class Member>
requires std::is_enum_v<Member>
constexpr std::string_view default_of_member(Member T::*) {
  return EnumWords<Member>::kWords.front();
}

/// The coefficients of a law serve translations and rotations; a geometry is what it is.
template <class T>
constexpr UnitUse unit_use_of(const law::Dimension& dimension) {
  const bool pure = dimension == law::dimension::kNone;
  return requires { T::kFormula; }
  &&!pure ? UnitUse::kSlip : UnitUse::kDeclared;
}

template <class T, class Visitor>
void for_each_key(Visitor&& visitor) {
  if constexpr (Declared<T>) {
    T::declare(visitor);
  } else {
    std::apply(
        [&](const auto&... field) {
          (visitor(field.key, field.member,
                   KeyInfo{.required = field.required,
                           .text = field.text,
                           .default_text = default_of_member(field.member),
                           .dimension = declared(field.dimension),
                           .bounds = field.bounds,
                           .unit = unit_use_of<T>(field.dimension)}),
           ...);
        },
        T::fields());
  }
}

template <class T>
std::vector<std::string_view> keys_of() {
  std::vector<std::string_view> keys;
  for_each_key<T>([&](std::string_view key, auto, const KeyInfo&) { keys.push_back(key); });
  return keys;
}

/// Tells whether a map has keys that T does not: then a message that something is missing would
/// only repeat that one of them is misspelt.
template <class T>
bool has_unknown_key(const Node& node) {
  const std::vector<std::string_view> allowed = keys_of<T>();
  for (const Entry entry : node.entries()) {
    if (std::find(allowed.begin(), allowed.end(), entry.key.text()) == allowed.end()) return true;
  }
  return false;
}

/// Tells whether a map lacks `key` because it is misspelt.
template <class T>
bool is_misspelt(const Node& node, std::string_view key) {
  if (!node.is_map() || node.find(key)) return false;
  const std::vector<std::string_view> allowed = keys_of<T>();
  for (const Entry entry : node.entries()) {
    if (std::find(allowed.begin(), allowed.end(), entry.key.text()) != allowed.end()) continue;
    // Most names are not near this one at all.
    if (!base::nearest_name(entry.key.text(), std::span(&key, 1))) continue;
    if (base::nearest_name(entry.key.text(), allowed) == key) return true;
  }
  return false;
}

/// Reads the keys of a map into a struct; all errors are reported.
template <class T>
bool read_struct(Binder& binder, const Node& node, const Path& path, T& out) {
  if (!node.is_map()) {
    binder.wrong_kind(node, path, "a map");
    return false;
  }
  bool good = true;
  const std::vector<std::string_view> allowed = keys_of<T>();
  std::vector<std::string_view> meant;  // a misspelt key is not missing as well
  for (const Entry entry : node.entries()) {
    if (std::find(allowed.begin(), allowed.end(), entry.key.text()) == allowed.end()) {
      std::string_view hint;
      if constexpr (requires { T::kForeignKey; }) {
        if (entry.key.text() == T::kForeignKey.key) hint = T::kForeignKey.text;
      }
      const auto key = binder.unknown_key(entry.key, path / entry.key.text(), allowed, hint);
      if (key) meant.push_back(*key);
      good = false;
    }
  }
  for_each_key<T>([&](std::string_view key, auto member, const KeyInfo& info) {
    using Member = std::remove_reference_t<decltype(out.*member)>;
    const std::optional<Node> value = node.find(key);
    if (value) {
      good = Codec<Member>::read(binder, *value, path / key, info, out.*member) && good;
    } else if (info.required) {
      const bool misspelt = std::find(meant.begin(), meant.end(), key) != meant.end();
      if (!misspelt) binder.missing_key(node, path, key, Codec<Member>::wanted(info));
      good = false;
    }
  });
  return good;
}

template <class T>
Json struct_schema() {
  Json schema;
  schema["type"] = "object";
  Json required = Json(base::json::Array{});
  bool any_required = false;
  Json properties = Json(base::json::Object{});
  for_each_key<T>([&](std::string_view key, auto member, const KeyInfo& info) {
    using Member = std::remove_reference_t<decltype(std::declval<T&>().*member)>;
    Json property = Codec<Member>::schema(info);
    property["description"] = info.text;
    properties[key] = std::move(property);
    if (info.required) {
      required.push_back(key);
      any_required = true;
    }
  });
  schema["properties"] = std::move(properties);
  if (any_required) schema["required"] = std::move(required);
  schema["additionalProperties"] = false;
  return schema;
}

template <class T>
void struct_rows(const std::string& path, std::vector<KeyRow>& rows) {
  for_each_key<T>([&](std::string_view key, auto member, const KeyInfo& info) {
    using Member = std::remove_reference_t<decltype(std::declval<T&>().*member)>;
    const std::string here = path.empty() ? std::string(key) : path + "." + std::string(key);
    rows.push_back({here, Codec<Member>::wanted(info), info});
    Codec<Member>::rows(here, rows);
  });
}

template <class T>
requires(Declared<T> || HasFields<T>) struct Codec<T> {
  static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo&, T& out) {
    return read_struct(binder, node, path, out);
  }
  static Json schema(const KeyInfo&) { return struct_schema<T>(); }
  static std::string wanted(const KeyInfo&) { return "a map"; }
  static void rows(const std::string& path, std::vector<KeyRow>& rows) {
    struct_rows<T>(path, rows);
  }
};

// ---------------------------------------------------------------------------------------------
// Leaves.

template <>
struct Codec<double> {
  static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info,
                   double& out);
  static Json schema(const KeyInfo& info);
  static std::string wanted(const KeyInfo&) { return "a number"; }
  static void rows(const std::string&, std::vector<KeyRow>&) {}
};

template <>
struct Codec<int> {
  static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info,
                   int& out);
  static Json schema(const KeyInfo& info);
  static std::string wanted(const KeyInfo&) { return "an integer"; }
  static void rows(const std::string&, std::vector<KeyRow>&) {}
};

template <>
struct Codec<bool> {
  static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info,
                   bool& out);
  static Json schema(const KeyInfo& info);
  static std::string wanted(const KeyInfo&) { return "true or false"; }
  static void rows(const std::string&, std::vector<KeyRow>&) {}
};

template <>
struct Codec<std::string> {
  static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info,
                   std::string& out);
  static Json schema(const KeyInfo& info);
  static std::string wanted(const KeyInfo&) { return "a text"; }
  static void rows(const std::string&, std::vector<KeyRow>&) {}
};

/// "linear or smooth", as messages and the reference list words; marks stand in quotes.
std::string listed(std::span<const std::string_view> words);

bool read_word(Binder& binder, const Node& node, const Path& path,
               std::span<const std::string_view> words, std::size_t& index);

template <class E>
requires std::is_enum_v<E>
struct Codec<E> {
  static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo&, E& out) {
    std::size_t index = 0;
    if (!read_word(binder, node, path, EnumWords<E>::kWords, index)) return false;
    out = static_cast<E>(index);
    return true;
  }
  static Json schema(const KeyInfo&) {
    Json words = Json(base::json::Array{});
    for (const std::string_view word : EnumWords<E>::kWords) words.push_back(word);
    Json schema;
    schema["enum"] = std::move(words);
    return schema;
  }
  static std::string wanted(const KeyInfo&) { return listed(EnumWords<E>::kWords); }
  static void rows(const std::string&, std::vector<KeyRow>&) {}
};

template <>
struct Codec<law::UnitName> {
  static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info,
                   law::UnitName& out);
  static Json schema(const KeyInfo& info);
  static std::string wanted(const KeyInfo&) { return "the name of a unit"; }
  static void rows(const std::string&, std::vector<KeyRow>&) {}
};

/// The tree itself, for what is read once more is known (predefined friction).
template <>
struct Codec<Node>;

// ---------------------------------------------------------------------------------------------
// Wrappers.

template <class T>
struct Codec<std::optional<T>> {
  static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info,
                   std::optional<T>& out) {
    T value{};
    if (!Codec<T>::read(binder, node, path, info, value)) return false;
    out = std::move(value);
    return true;
  }
  static Json schema(const KeyInfo& info) { return Codec<T>::schema(info); }
  static std::string wanted(const KeyInfo& info) { return Codec<T>::wanted(info); }
  static void rows(const std::string& path, std::vector<KeyRow>& rows) {
    Codec<T>::rows(path, rows);
  }
};

template <class T>
struct Codec<At<T>> {
  static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info,
                   At<T>& out) {
    out.node = node;
    out.path = path;
    out.sound = Codec<T>::read(binder, node, path, info, out.value);
    return out.sound;
  }
  static Json schema(const KeyInfo& info) { return Codec<T>::schema(info); }
  static std::string wanted(const KeyInfo& info) { return Codec<T>::wanted(info); }
  static void rows(const std::string& path, std::vector<KeyRow>& rows) {
    Codec<T>::rows(path, rows);
  }
};

template <class T>
struct Codec<std::vector<T>> {
  static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info,
                   std::vector<T>& out) {
    if (!node.is_sequence()) {
      binder.wrong_kind(node, path, wanted(info));
      return false;
    }
    // The items of a list may be a thousand times as large as their text: 32 MB is enough.
    constexpr std::size_t kMostItems = (std::size_t{1} << 25U) / sizeof(T);
    const std::size_t most = info.most > 0 ? info.most : kMostItems;
    if (!binder.few_enough(node, path, most)) return false;
    bool good = true;
    out.clear();
    out.reserve(node.size());
    for (std::size_t i = 0; i < node.size(); ++i) {
      // A faulty item keeps its place: messages count from it.
      good = Codec<T>::read(binder, node[i], path / i, info, out.emplace_back()) && good;
      if (binder.flooded()) out.pop_back();
    }
    return good;
  }
  static Json schema(const KeyInfo& info) {
    Json schema;
    schema["type"] = "array";
    schema["items"] = Codec<T>::schema(info);
    if (info.most > 0) schema["maxItems"] = static_cast<double>(info.most);
    return schema;
  }
  static std::string wanted(const KeyInfo& info) {
    return "a list, each item " + Codec<T>::wanted(info);
  }
  static void rows(const std::string& path, std::vector<KeyRow>& rows) {
    Codec<T>::rows(path + "[]", rows);
  }
};

template <class T>
struct Codec<Named<T>>;  // only as NamedMap<T>

template <class T>
struct Codec<std::vector<Named<T>>> {
  static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info,
                   NamedMap<T>& out) {
    if (!node.is_map()) {
      binder.wrong_kind(node, path, wanted(info));
      return false;
    }
    if (info.most > 0 && !binder.few_enough(node, path, info.most)) return false;
    bool good = true;
    out.clear();
    out.reserve(node.size());
    for (const Entry entry : node.entries()) {
      Named<T>& item = out.emplace_back();
      item.name = std::string(entry.key.text());
      item.key = entry.key;
      item.node = entry.value;
      item.path = path / entry.key.text();
      item.sound = Codec<T>::read(binder, entry.value, item.path, info, item.value);
      good = item.sound && good;
    }
    return good;
  }
  static Json schema(const KeyInfo& info) {
    Json schema;
    schema["type"] = "object";
    schema["additionalProperties"] = Codec<T>::schema(info);
    if (info.most > 0) schema["maxProperties"] = static_cast<double>(info.most);
    return schema;
  }
  static std::string wanted(const KeyInfo& info) {
    return "a map from names to " + Codec<T>::wanted(info);
  }
  static void rows(const std::string& path, std::vector<KeyRow>& rows) {
    Codec<T>::rows(path + ".NAME", rows);
  }
};

}  // namespace slipbench::driver::yaml
