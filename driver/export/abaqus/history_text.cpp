// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <variant>

#include "driver/bench/run_case.hpp"
#include "driver/case/quantity.hpp"
#include "driver/export/abaqus/deck_parts.hpp"
#include "driver/export/deck_text.hpp"

namespace slipbench::driver::exports {
namespace {

/// Profiles of more rows than this are no history of a deck.
constexpr std::size_t kMostSamples = 200'000;

constexpr const char* kStepEnd =
    "*OUTPUT, HISTORY\n*ELEMENT OUTPUT, ELSET=JOINT\nCTF, CSF, CNF, CASU, CIVC\n*END STEP\n";

bool is_motion(int quantity) { return quantity < cases::kFirstForce; }
bool is_force(int quantity) {
  return quantity >= cases::kFirstForce && quantity < cases::kTemperatureQuantity;
}

}  // namespace

std::string DeckParts::amplitude(const std::string& data, const std::string& parameters) {
  std::string name = fmt::format("A{}", ++amplitude_count_);
  amplitudes_ += "*AMPLITUDE, NAME=" + name + parameters + "\n" + data;
  return name;
}

std::span<const DeckParts::Sample> DeckParts::samples_of(std::size_t step_index, int pass) const {
  // They stand in the order of the run.
  const auto place = [](const Sample& one) { return std::pair(one.step, one.pass); };
  const std::pair wanted(static_cast<int>(step_index), pass);
  const auto first = std::ranges::lower_bound(samples_, wanted, {}, place);
  const auto past = std::ranges::upper_bound(samples_, wanted, {}, place);
  return {first, past};
}

/// An amplitude of the values that a quantity has in a pass of a step.
std::string DeckParts::sampled(int quantity, std::size_t step_index, int pass) {
  const auto q = static_cast<std::size_t>(quantity);
  const double initial = is_motion(quantity) ? problem_.initial[quantity] : 0.0;
  std::vector<std::string> items{"0.", whole_(values_[q] - initial)};
  for (const Sample& one : samples_of(step_index, pass)) {
    items.push_back(whole_(one.time - start_));
    items.push_back(whole_(one.quantities[q] - initial));
  }
  return amplitude(data_lines(items), ", VALUE=ABSOLUTE");
}

/// A triangle as its corners, and its ends.
std::string DeckParts::triangle(const history::Wave& wave, double duration, double initial) {
  const auto value = [&](double time) {
    const double way = time / wave.period - std::floor(time / wave.period);
    const double part = way < 0.25 ? 4.0 * way : way < 0.75 ? 2.0 - 4.0 * way : 4.0 * way - 4.0;
    return wave.mean + wave.amplitude * part - initial;
  };
  std::vector<std::string> items{"0.", whole_(value(0.0))};
  for (int corner = 0;; ++corner) {
    const double time = wave.period * (0.25 + 0.5 * corner);
    if (time >= duration) break;
    items.push_back(whole_(time));
    items.push_back(whole_(wave.mean + (corner % 2 == 0 ? 1.0 : -1.0) * wave.amplitude - initial));
  }
  items.push_back(whole_(duration));
  items.push_back(whole_(value(duration)));
  return amplitude(data_lines(items), ", VALUE=ABSOLUTE");
}

std::string DeckParts::history() {
  // What is sampled comes from a run: its rows have all that drives the case.
  const auto ended = bench::run_case(problem_, [&](const bench::Row& row) {
    if (row.index == 0) {
      values_.assign(row.quantities.begin(), row.quantities.end());
      start_ = row.step_time;
    }
    if (samples_.size() > kMostSamples) refuse("its history has too many increments for a deck");
    if (row.index > 0 || row.duration > 0.0) {
      samples_.push_back(
          {row.step, row.pass, row.step_time, {row.quantities.begin(), row.quantities.end()}});
    }
  });
  if (!ended) refuse("the case does not run to its end: " + ended.error().message);
  std::string steps;
  if (problem_.measured) {
    steps = measured();
    return amplitudes_ + steps;
  }
  for (std::size_t i = 0; i < problem_.steps.size(); ++i) {
    for (int pass = 0; pass < problem_.steps[i].repeat; ++pass) steps += step(i, pass);
  }
  return amplitudes_ + steps;
}

/// Holds node a, and the components of which the case says nothing.
std::string DeckParts::supports() const {
  const law::ComponentSet& free = problem_.connection.info.available;
  std::string text = "*BOUNDARY\n1, 1, 6\n";
  const auto hold = [&](int c) {
    text += fmt::format("*CONNECTOR MOTION, FIXED\nJOINT, {}\n", c + 1);
  };
  for (int c = 0; c < law::kComponents; ++c) {
    // A free component that nothing drives would move as it likes; a belt's flow at a is a result.
    if (!free.contains(c) || (problem_.belt && c != 1)) continue;
    if (cases::is_driven(problem_, c) || cases::is_driven(problem_, cases::kFirstForce + c)) {
      continue;
    }
    hold(c);
  }
  constexpr int kSecondTangent = 2;
  if (is_contact() && written_.connector.value.dimension.value == 2) hold(kSecondTangent);
  return text;
}

std::string DeckParts::measured() {
  std::vector<double> ends;
  for (const Sample& one : samples_) ends.push_back(one.time - start_);
  const double duration = ends.back();
  const double increment = duration / static_cast<double>(ends.size());
  double off = 0.0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    off = std::max(off, std::abs(ends[i] - static_cast<double>(i + 1) * increment));
  }
  constexpr double kEqual = 1e-9;  // of a step's length: times are read from digits
  if (off > kEqual * duration) {
    note(Loss::Kind::kApproximated,
         "increments: of equal length, in place of one from row to row of the measured history");
  }
  std::string text = "*STEP, NAME=\"measured\", NLGEOM=NO\n*STATIC, DIRECT\n" +
                     data_lines({whole_(increment), whole_(duration)}) + supports();
  for (const history::MeasuredColumn& one : problem_.measured->columns) {
    history::Tabular profile;
    profile.times.push_back(0.0);
    profile.values.push_back(values_[one.quantity]);
    for (const Sample& sample : samples_) {
      profile.times.push_back(sample.time - start_);
      profile.values.push_back(sample.quantities[one.quantity]);
    }
    text += drive({static_cast<int>(one.quantity), std::move(profile)}, 0, 0);
  }
  return text + kStepEnd;
}

std::string DeckParts::step(std::size_t index, int pass) {
  const cases::Step& step = problem_.steps[index];
  std::string text =
      fmt::format("*STEP, NAME={}, NLGEOM=NO\n*STATIC, DIRECT\n",
                  name_in_quotes(step.name + (pass > 0 ? fmt::format(" {}", pass + 1) : "")));
  text += data_lines({whole_(step.duration / step.increments), whole_(step.duration)});
  if (index == 0 && pass == 0) text += supports();
  std::string drives;
  for (const cases::Drive& one : step.drives) drives += drive(one, index, pass);
  text += drives;
  if (pass == 0) text += changes(step);
  text += kStepEnd;
  if (const auto rows = samples_of(index, pass); !rows.empty()) values_ = rows.back().quantities;
  return text;
}

std::string DeckParts::drive(const cases::Drive& drive, std::size_t step_index, int pass) {
  const int quantity = drive.quantity;
  // A measured history has tables alone, which know their own length.
  const double duration = problem_.measured ? 0.0 : problem_.steps[step_index].duration;
  const auto q = static_cast<std::size_t>(quantity);
  const int component = is_motion(quantity) ? quantity : quantity - cases::kFirstForce;
  const double initial = is_motion(quantity) ? problem_.initial[component] : 0.0;
  std::string name;
  double magnitude = 1.0;
  if (const auto* to = std::get_if<history::LinearTo>(&drive.profile);
      to != nullptr && (is_motion(quantity) || is_force(quantity))) {
    magnitude = to->value - initial;
  } else if (const auto* constant = std::get_if<history::Constant>(&drive.profile)) {
    magnitude = constant->value - initial;
    name = amplitude(data_lines({"0.", "1.", whole_(duration), "1."}), "");
  } else if (const auto* smooth = std::get_if<history::SmoothTo>(&drive.profile)) {
    name = amplitude(data_lines({"0.", whole_(values_[q] - initial), whole_(duration),
                                 whole_(smooth->value - initial)}),
                     ", DEFINITION=SMOOTH STEP, VALUE=ABSOLUTE");
  } else if (const auto* wave = std::get_if<history::Wave>(&drive.profile);
             wave != nullptr && wave->shape == history::WaveShape::kSine &&
             (wave->phase == 0.0 || wave->phase == std::numbers::pi / 2.0)) {
    const std::string height = whole_(wave->amplitude);
    name = amplitude(
        data_lines({"1", whole_(2.0 * std::numbers::pi / wave->period), "0.",
                    whole_(wave->mean - initial)}) +
            (wave->phase == 0.0 ? data_lines({"0.", height}) : data_lines({height, "0."})),
        ", DEFINITION=PERIODIC, VALUE=ABSOLUTE");
  } else if (const auto* table = std::get_if<history::Tabular>(&drive.profile)) {
    std::vector<std::string> items;
    for (std::size_t i = 0; i < table->times.size(); ++i) {
      items.push_back(whole_(table->times[i]));
      items.push_back(whole_(table->values[i] - initial));
    }
    name = amplitude(data_lines(items), ", VALUE=ABSOLUTE");
  } else if (wave != nullptr && wave->shape == history::WaveShape::kTriangle &&
             wave->phase == 0.0) {
    name = triangle(*wave, duration, initial);
  } else {
    if (std::holds_alternative<history::PositionFormula>(drive.profile) && pass == 0) {
      note(Loss::Kind::kApproximated,
           cases::quantity_name(quantity) +
               " follows the position; the deck has its values of a run");
    }
    name = sampled(quantity, step_index, pass);
  }
  const std::string parameter = name.empty() ? std::string() : ", AMPLITUDE=" + name;
  const std::string value = whole_(magnitude);
  if (is_motion(quantity)) {
    return fmt::format("*CONNECTOR MOTION{}\nJOINT, {}, {}\n", parameter, component + 1, value);
  }
  if (is_force(quantity)) {
    const bool free = problem_.connection.info.available.contains(component);
    return free ? fmt::format("*CONNECTOR LOAD{}\nJOINT, {}, {}\n", parameter, component + 1, value)
                : fmt::format("*CLOAD{}\n2, {}, {}\n", parameter, component + 1, value);
  }
  if (quantity == cases::kTemperatureQuantity) {
    return fmt::format("*TEMPERATURE{}\n1, {}\n2, {}\n", parameter, value, value);
  }
  const int field = quantity - cases::kFirstField;
  if (field < 0 || field >= law::kMaxFields) {
    refuse("its history drives " + cases::quantity_name(quantity) + ", which a deck cannot");
  }
  return fmt::format("*FIELD, VARIABLE={}{}\n1, {}\n2, {}\n", field + 1, parameter, value, value);
}

std::string DeckParts::changes(const cases::Step& step) {
  if (step.friction_changes.empty()) return {};
  if (problem_.definitions.size() != 1 || step.friction_changes.size() != 1) {
    refuse("*CHANGE FRICTION changes all friction of a connector, not one definition of several");
  }
  const cases::FrictionChange& change = step.friction_changes.front();
  std::string parameter;
  if (const auto* table = std::get_if<history::Tabular>(&change.amplitude)) {
    std::vector<std::string> items;
    for (std::size_t i = 0; i < table->times.size(); ++i) {
      items.push_back(whole_(table->times[i]));
      items.push_back(whole_(table->values[i]));
    }
    parameter = ", AMPLITUDE=" + amplitude(data_lines(items), "");
  } else if (std::holds_alternative<history::SmoothTo>(change.amplitude)) {
    parameter = ", AMPLITUDE=" + amplitude(data_lines({"0.", "0.", whole_(step.duration), "1."}),
                                           ", DEFINITION=SMOOTH STEP");
  }
  return "*CHANGE FRICTION, ELSET=JOINT" + parameter + "\n" +
         coefficient(change.law, change.force_limit, change.stick);
}

}  // namespace slipbench::driver::exports
