// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/describe_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include "driver/base/text/curve_drawing.hpp"
#include "driver/read/keys/case_codecs.hpp"
#include "driver/read/keys/case_reference.hpp"
#include "driver/read/keys/law_numbers.hpp"
#include "law/friction/law_list.hpp"

namespace slipbench::driver::commands {
namespace {

constexpr std::size_t kLineLength = 100;

/// Cuts the text before `separator` off the front of `text`.
std::string_view take(std::string_view& text, std::string_view separator) {
  const std::size_t end = text.find(separator);
  const std::string_view front = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + separator.size());
  return front;
}

/// A formula in pieces, "V <= C5: mu = ..; V >= C6: ..", with a piece a line and the conditions in
/// a column of their own.
std::string laid_out(std::string_view formula) {
  std::vector<std::pair<std::string_view, std::string_view>> pieces;
  std::size_t width = 0;
  while (!formula.empty()) {
    std::string_view piece = take(formula, "; ");
    const std::string_view condition =
        piece.find(": ") == std::string_view::npos ? std::string_view() : take(piece, ": ");
    width = std::max(width, condition.size());
    pieces.emplace_back(condition, piece);
  }
  std::string text;
  for (const auto& [condition, equation] : pieces) {
    text += fmt::format("    {:<{}}{}\n", condition, width == 0 ? 0 : width + 3, equation);
  }
  return text;
}

/// Lines of at most kLineLength characters, each after `indent` blanks.
std::string wrapped(std::string_view text, std::size_t indent) {
  std::string out;
  std::string line;
  while (!text.empty()) {
    const std::string_view word = take(text, " ");
    if (!line.empty() && indent + line.size() + 1 + word.size() > kLineLength) {
      out += std::string(indent, ' ') + line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + std::string(word);
  }
  return out + std::string(indent, ' ') + line + "\n";
}

/// A dimension as a user names it: "1/pressure".
std::string_view dimension_words(const base::Dimension& dimension) {
  struct Word {
    base::Dimension dimension;
    std::string_view text;
  };
  static constexpr std::array<Word, 11> kWords{{{{}, "a pure number"},
                                                {{0, 1, -1}, "a speed"},
                                                {{0, -1, 1}, "1/speed"},
                                                {{0, -2, 2}, "1/speed^2"},
                                                {{-1, 2, 0}, "1/pressure"},
                                                {{-2, 4, 0}, "1/pressure^2"},
                                                {{-1, 1, 1}, "1/(pressure speed)"},
                                                {{1, -2, 0}, "a pressure"},
                                                {{0, 2, 0}, "an area"},
                                                {{1, 0, 0}, "a force"},
                                                {{0, 0, 1}, "a time"}}};
  for (const Word& word : kWords) {
    if (word.dimension == dimension) return word.text;
  }
  return "";
}

std::string dimension_in_words(const base::Dimension& dimension) {
  const std::string symbols = read::dimension_text(dimension);
  return std::string(dimension_words(dimension)) + (symbols.empty() ? "" : " [" + symbols + "]");
}

/// \param width of the column of names
std::string symbol(std::size_t width, std::string_view name, std::string_view dimension,
                   std::string_view text, std::string_view wanted) {
  return fmt::format("    {:<{}} {:<30} {}{}\n", name, width, dimension, text,
                     wanted.empty() ? "" : fmt::format(" ({})", wanted));
}

/// Returns what the reader wants of a parameter: its bounds, and its default.
template <class Member>
std::string wanted(const yaml::KeyInfo& info) {
  std::string text = yaml::in_words(info.bounds);
  if constexpr (!std::is_arithmetic_v<Member> && !std::is_same_v<Member, std::optional<double>>) {
    text = yaml::Codec<Member>::wanted(info);
  }
  const std::string fallback =
      info.required ? "required"
                    : "default " + (info.default_text.empty() ? std::string("0")
                                                              : std::string(info.default_text));
  return text + (text.empty() ? "" : ", ") + fallback;
}

template <class Law>
std::string symbols(const law::FrictionLaw& example) {
  constexpr base::Dimension kSpeed{0, 1, -1};
  constexpr base::Dimension kPressure{1, -2, 0};
  std::size_t width = 10;
  if constexpr (yaml::HasFields<Law>) {
    yaml::for_each_key<Law>([&](std::string_view key, auto, const yaml::KeyInfo&) {
      width = std::max(width, key.size());
    });
  }
  std::string text;
  if (law::depends_on_slip_rate(example)) {
    text += symbol(width, "V", dimension_in_words(kSpeed),
                   "Slip rate: the rate of the slip, or of the relative motion.", "");
  }
  if constexpr (requires(Law law) { law.area; }) {
    text += symbol(width, "p", dimension_in_words(kPressure), "Pressure F_N/area.", "");
  } else if (law::depends_on_contact_force(example)) {
    text += symbol(width, "F_N", dimension_in_words(base::kForce), "Normal force.", "");
  }
  if constexpr (yaml::HasFields<Law>) {
    yaml::for_each_key<Law>([&](std::string_view key, auto member, const yaml::KeyInfo& info) {
      using Member = std::remove_cvref_t<decltype(std::declval<Law&>().*member)>;
      constexpr bool kNumber =
          std::is_arithmetic_v<Member> || std::is_same_v<Member, std::optional<double>>;
      text += symbol(width, key, kNumber ? dimension_in_words(info.dimension) : "a word", info.text,
                     wanted<Member>(info));
    });
  }
  return text;
}

/// mu over the slip rate, or over the pressure where the rate does not enter, of a typical set of
/// parameters; empty for a constant.
std::string drawing(const law::FrictionLaw& law) {
  const law::LawRange range = law::range(law);
  const double area = law::area_of(law);
  const bool by_rate = law::depends_on_slip_rate(law);
  const bool by_force = law::depends_on_contact_force(law);
  if (!by_rate && !by_force) return {};
  const law::Ambient ambient;
  const auto mu = [&](double rate, double force) {
    return law::evaluate(law, ambient, {.slip_rate = rate, .contact_force = force}).mu;
  };
  base::CurveDrawing picture;
  picture.y_name = "mu";
  if (by_rate) {
    picture.x_end = range.slip_rate > 0.0 ? range.slip_rate : 1.0;
    picture.x_name = "V";
    constexpr std::array<char, 3> kPens{'*', 'o', '+'};
    for (std::size_t i = 0; i < (by_force ? kPens.size() : 1); ++i) {
      const double force = by_force ? 0.5 * static_cast<double>(i) * range.contact_force : 0.0;
      std::string name;
      if (by_force) {
        name = area > 0.0 ? fmt::format("p = {:.3g}", force / area)
                          : fmt::format("F_N = {:.3g}", force);
      }
      picture.curves.push_back({kPens[i], name, [=](double v) { return mu(v, force); }});
    }
    for (const law::Landmark& landmark : range.landmarks) {
      if (landmark.name.empty()) continue;
      picture.points.push_back(
          {std::string(landmark.name), landmark.slip_rate, mu(landmark.slip_rate, 0.0)});
    }
  } else {
    const double per_force = area > 0.0 ? area : 1.0;
    picture.x_end = (range.contact_force > 0.0 ? range.contact_force : 1.0) / per_force;
    picture.x_name = area > 0.0 ? "p" : "F_N";
    picture.curves.push_back({'*', "", [=](double x) { return mu(0.0, x * per_force); }});
  }
  return base::draw(picture);
}

template <class Law>
std::string describe() {
  const Law example = Law::example();
  const law::FrictionLaw law = example;
  std::string text =
      fmt::format("{} (law of the coefficient of friction)\n  {}\n\n", Law::kName, Law::kTitle);
  text += laid_out(Law::kFormula);
  if (const std::string table = symbols<Law>(law); !table.empty()) {
    text += "\n  symbols\n" + table;
  }
  if constexpr (Law::kRules.size() > 0) {
    text += "\n  rules\n";
    for (const std::string_view rule : Law::kRules) text += fmt::format("    {}\n", rule);
  }
  if constexpr (requires { Law::kNote; }) text += "\n" + wrapped(Law::kNote, 2);
  if (law::has_floor(law)) {
    text += "\n  A coefficient below 1e-30 is kept at 1e-30, and the run says how often.\n";
  }
  if (const std::string picture = drawing(law); !picture.empty()) {
    std::string of = "an example";
    if constexpr (yaml::HasFields<Law>) of = read::numbers(example);
    text += fmt::format("\n  mu for {}\n{}", of, picture);
  }
  return text + fmt::format("\n  source: {}\n", Law::kSource);
}

/// Subject of a map of the case format, where a table of its keys does not say it.
struct Topic {
  std::string_view key;
  std::string_view title;
  std::string_view text;
};
constexpr std::array<Topic, 6> kTopics{{
    {"formulation", "contact penalty in place of stick and return mapping (Radioss Iform)",
     "The penalty formulations of a Radioss contact in place of the connector's stick and return "
     "mapping. viscous: F = min(C V, mu N) v/V, no stick, a load below the limit creeps at P/C. "
     "stiffness: F* = F + K_t v dt, returned to the limit."},
    {"filter", "first-order filter of its friction force (Radioss Ifiltr, Xfreq)",
     "A first-order filter of the friction force of a formulation, F_k = alpha F + (1 - alpha) "
     "F_{k-1}, behind the limit and reset where the contact opens. The filtered force lags: it "
     "may be above mu N where N falls."},
    {"orthotropic", "two coefficients at right angles (Radioss Idir)",
     "Two coefficients at right angles: the limit is the ellipse (F1/(mu1 N))^2 + (F2/(mu2 N))^2 "
     "= 1, and a force beyond it returns to the closest point."},
    {"direction_dependent", "a coefficient for each sense of the slip of one component",
     "Two coefficients for one component: that of the direction in which the friction force would "
     "slip is in force. MU is the one that was used."},
    {"dead_zone", "backlash in series with the friction of one component",
     "A gap in series with the friction of one component: at a reversal the spring of the stick "
     "unloads, the connector travels through the gap without force, and the spring loads the other "
     "way. PLAY1 is the place in the gap; CP and CU are the connector's, CASU counts the slip of "
     "the friction alone, and no work is done in the gap."},
    {"friction_pairs", "table of part pairs and their coefficients (Radioss /FRICTION)",
     "A table of contact pairs: the last entry whose two sides hold the two parts of the "
     "connector, in either order, gives the coefficient; else the default does."},
}};
std::string_view topic(std::string_view key) {
  for (const Topic& topic : kTopics) {
    if (topic.key == key) return topic.text;
  }
  return {};
}

/// An option of a Radioss block that leads to a key of the case, or to the laws.
std::string_view key_of_option(std::string_view name) {
  struct Option {
    std::string_view name;
    std::string_view key;
  };
  static constexpr std::array<Option, 5> kOptions{{{"Ifiltr", "filter"},
                                                   {"Xfreq", "filter"},
                                                   {"Iform", "formulation"},
                                                   {"VISF", "formulation"},
                                                   {"Idir", "orthotropic"}}};
  for (const Option& option : kOptions) {
    if (option.name == name) return option.key;
  }
  return name;
}

std::string_view last_of(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? path : path.substr(dot + 1);
}

/// A key below another one, with what it takes.
std::string key_below(std::string_view rest, const yaml::KeyRow& row) {
  const std::string dimension = read::dimension_text(row.info.dimension);
  std::string fallback = "required";
  if (!row.info.required) {
    const std::string_view text = row.info.default_text;
    fallback = "default: " + std::string(text.empty() ? "0" : text);
  }
  return fmt::format("    {:<24} {}{}, {}\n", rest, row.wanted,
                     dimension.empty() ? "" : " [" + dimension + "]", fallback) +
         wrapped(row.info.text, 29);
}

/// The keys below a path of the case format. The laws of a coefficient are described elsewhere.
std::string keys_below(std::string_view path, const std::vector<yaml::KeyRow>& rows) {
  std::string text;
  for (const yaml::KeyRow& row : rows) {
    const std::string_view inside = row.path;
    if (!inside.starts_with(path) || inside.size() == path.size()) continue;
    const std::string_view rest = inside.substr(path.size());
    if (rest.front() != '.' && rest.front() != '[') continue;
    if (rest.find(".coefficient.") != std::string_view::npos) continue;
    text += key_below(rest.front() == '.' ? rest.substr(1) : rest, row);
    if (rest.ends_with(".coefficient")) {
      text += wrapped("The laws by name: 'slipbench list laws', 'slipbench describe renard'.", 29);
    }
  }
  return text;
}

/// The laws with the numbers that a Radioss block gives them.
std::string laws_by_number() {
  std::string text =
      "Ifric (option of a Radioss /FRICTION block)\n" +
      wrapped(
          "The law of the coefficient. Here it stands by its name: coefficient: {renard: "
          "{...}}; 'slipbench describe' tells of each.",
          2) +
      fmt::format("\n    {:<3} {:<22} {}\n", 0, "a number", law::ConstantCoefficient::kTitle);
  [&]<class... Law>(std::type_identity<std::variant<Law...>>) {
    const auto add = [&](std::string_view name, std::string_view title) {
      constexpr std::string_view kNumber = "Ifric ";
      const std::size_t at = title.find(kNumber);
      if (at == std::string_view::npos) return;
      text +=
          fmt::format("    {:<3} {:<22} {}\n", title.substr(at + kNumber.size(), 1), name, title);
    };
    (add(Law::kName, Law::kTitle), ...);
  }(std::type_identity<law::LawList>{});
  return text + fmt::format("    {:<3} {:<22} {}\n", 4, law::ExponentialDecay::kName,
                            law::ExponentialDecay::kTitle);
}

}  // namespace

std::string describe_law(std::string_view name) {
  std::string text;
  [&]<class... Law>(std::type_identity<std::variant<Law...>>) {
    ((Law::kName == name ? void(text = describe<Law>()) : void()), ...);
  }(std::type_identity<law::LawList>{});
  return text;
}

std::string describe_key(std::string_view name) {
  if (name == "Ifric") return laws_by_number();
  static const std::vector<yaml::KeyRow> rows = read::case_rows();
  const std::string_view key = key_of_option(name);
  // The same map may stand in several places: its keys are told once.
  std::string places;
  std::string keys;
  for (const yaml::KeyRow& row : rows) {
    const std::string_view path = row.path;
    if (last_of(path) != key || topic(key).empty()) continue;
    places += fmt::format("  {}\n", path);
    if (keys.empty()) keys = keys_below(path, rows);
  }
  if (keys.empty()) return {};
  const std::string asked =
      key == name ? std::string() : fmt::format("{} (Radioss): here a part of '{}'\n\n", name, key);
  return asked + fmt::format("{} (key of a case)\n", key) + wrapped(topic(key), 2) + "\n" + places +
         keys;
}

std::vector<DescribedKey> described_keys() {
  std::vector<DescribedKey> keys;
  keys.reserve(std::size(kTopics));
  for (const Topic& topic : kTopics) keys.push_back({topic.key, topic.title});
  return keys;
}

}  // namespace slipbench::driver::commands
