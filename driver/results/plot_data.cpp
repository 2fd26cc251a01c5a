// SPDX-License-Identifier: Apache-2.0
#include "driver/results/plot_data.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

#include "driver/case/quantity.hpp"
#include "driver/history/csv_reader.hpp"
#include "driver/text/number.hpp"
#include "law/notation.hpp"

namespace slipbench::driver {
namespace {

/// What the '#' lines of a result say.
struct Preamble {
  std::string title;
  std::map<std::string, std::string, std::less<>> units;
  /// Name of a definition and its force columns, the coupled total first if there is one.
  std::vector<std::pair<std::string, std::vector<std::string>>> friction;
  /// Direction 1 of orthotropic definitions.
  std::map<std::string, std::array<double, 2>, std::less<>> directions;
};

/// Cuts the text before `separator` off the front of `text`.
std::string_view take(std::string_view& text, std::string_view separator) {
  const std::size_t end = text.find(separator);
  const std::string_view front = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + separator.size());
  return front;
}

void read_units(std::string_view text, Preamble& preamble) {
  while (!text.empty()) {
    std::string_view entry = take(text, ", ");
    const std::string name(take(entry, " ["));
    if (entry.ends_with(']')) entry.remove_suffix(1);
    preamble.units[name] = std::string(entry);
  }
}

void read_friction(std::string_view text, Preamble& preamble) {
  while (!text.empty()) {
    std::string_view entry = take(text, ", ");
    const std::string name(take(entry, " = "));
    std::vector<std::string> columns;
    if (entry.find('(') != std::string_view::npos) {
      columns.emplace_back(take(entry, "("));
      if (entry.ends_with(')')) entry.remove_suffix(1);
    }
    while (!entry.empty()) columns.emplace_back(take(entry, " "));
    preamble.friction.emplace_back(name, std::move(columns));
  }
}

void read_directions(std::string_view text, Preamble& preamble) {
  while (!text.empty()) {
    std::string_view entry = take(text, ", ");
    const std::string name(take(entry, " = "));
    const auto x = parse_number(take(entry, " "));
    const auto y = parse_number(entry);
    if (x && y) preamble.directions[name] = {*x, *y};
  }
}

Preamble read_preamble(const std::filesystem::path& file) {
  Preamble preamble;
  std::ifstream in(file);
  std::string line;
  while (in.peek() == '#' && std::getline(in, line)) {
    std::string_view text = line;
    const std::string_view key = take(text, ": ");
    if (key == "# title") preamble.title = std::string(text);
    if (key == "# columns") read_units(text, preamble);
    if (key == "# friction") read_friction(text, preamble);
    if (key == "# direction1") read_directions(text, preamble);
  }
  return preamble;
}

/// The position a friction force column goes with: CSF1 with CP1, CSM2 with CPR2, CSF2.ring1 with
/// CP2.
std::string position_of(const std::string& column) {
  const std::string force = column.substr(0, column.find('.'));
  for (int c = 0; c < law::kComponents; ++c) {
    if (force == force_column("CSF", c)) return motion_name(c);
  }
  return {};
}

/// Chooses the columns to read and says what is drawn of each definition.
class Selection {
 public:
  Selection(const Preamble& preamble, std::span<const std::string> header, PlotData& data)
      : preamble_(preamble), header_(header), data_(data) {}

  void select() {
    add("t");
    for (const auto& [name, forces] : preamble_.friction) {
      PlotDefinition definition;
      definition.name = name;
      definition.several = preamble_.friction.size() > 1;
      const std::string suffix = definition.several ? "." + name : "";
      for (const std::string& force : forces) {
        const int column = add(force);
        if (column < 0) continue;
        if (force == "CSFC") {
          definition.total = column;
        } else {
          definition.components.push_back(column);
          definition.positions.push_back(add(position_of(force)));
        }
      }
      // A belt has another limit in each sense; FLIM is only that of the side its force lies on.
      const std::string& first = forces.empty() ? name : forces.front();
      const std::string of_belt = first.substr(0, first.find('.'));
      definition.limit_below = add(of_belt + "_MIN" + first.substr(of_belt.size()));
      definition.limit = definition.limit_below >= 0
                             ? add(of_belt + "_MAX" + first.substr(of_belt.size()))
                             : add("FLIM" + suffix);
      definition.status = add("STATUS" + suffix);
      if (const auto direction = preamble_.directions.find(name);
          direction != preamble_.directions.end()) {
        definition.direction = direction->second;
        definition.normal_force = add("FN" + suffix);
        definition.coefficients = {add("MU1" + suffix), add("MU2" + suffix)};
      }
      if (definition.total >= 0 || !definition.components.empty()) {
        data_.definitions.push_back(std::move(definition));
      }
    }
  }

 private:
  int add(const std::string& name) {
    const auto known = std::find_if(data_.columns.begin(), data_.columns.end(),
                                    [&](const PlotColumn& column) { return column.name == name; });
    if (known != data_.columns.end()) return static_cast<int>(known - data_.columns.begin());
    if (std::find(header_.begin(), header_.end(), name) == header_.end()) return -1;
    const auto unit = preamble_.units.find(name);
    data_.columns.push_back({name, unit == preamble_.units.end() ? "" : unit->second});
    return static_cast<int>(data_.columns.size()) - 1;
  }

  const Preamble& preamble_;
  std::span<const std::string> header_;
  PlotData& data_;
};

/// The rows of one piece of time, of which only the telling ones are kept.
class Bucket {
 public:
  explicit Bucket(std::size_t columns) : lowest_(columns), highest_(columns) {}

  void add(long index, std::span<const double> row) {
    const Sample here{index, {row.begin(), row.end()}};
    if (empty_) {
      first_ = here;
      std::fill(lowest_.begin(), lowest_.end(), here);
      std::fill(highest_.begin(), highest_.end(), here);
      empty_ = false;
    }
    last_ = here;
    for (std::size_t k = 1; k < row.size(); ++k) {
      if (row[k] < lowest_[k].row[k]) lowest_[k] = here;
      if (row[k] > highest_[k].row[k]) highest_[k] = here;
    }
  }

  void move_to(std::vector<double>& rows) {
    if (empty_) return;
    std::map<long, const std::vector<double>*> telling{{first_.index, &first_.row},
                                                       {last_.index, &last_.row}};
    for (std::size_t k = 1; k < lowest_.size(); ++k) {
      telling.emplace(lowest_[k].index, &lowest_[k].row);
      telling.emplace(highest_[k].index, &highest_[k].row);
    }
    for (const auto& [index, row] : telling) rows.insert(rows.end(), row->begin(), row->end());
    empty_ = true;
  }

 private:
  struct Sample {
    long index = 0;
    std::vector<double> row;
  };
  Sample first_;
  Sample last_;
  std::vector<Sample> lowest_;
  std::vector<Sample> highest_;
  bool empty_ = true;
};

/// Lengthens the last span of this status, or begins one.
void add_span(std::vector<RegimeSpan>& spans, int status, double from, double to, double gap) {
  if (status == 1) return;
  for (auto span = spans.rbegin(); span != spans.rend() && span->to >= from - gap; ++span) {
    if (span->status == status) {
      span->to = to;
      return;
    }
  }
  spans.push_back({from, to, status});
}

}  // namespace

tl::expected<PlotData, HistoryError> read_plot_data(const std::filesystem::path& file,
                                                    const std::string& shown_name, int buckets) {
  auto opened = CsvReader::open(file, std::vector<std::string>{"t"}, shown_name);
  if (!opened) return tl::unexpected(std::move(opened.error()));
  const Preamble preamble = read_preamble(file);
  PlotData data;
  data.title = preamble.title;
  Selection(preamble, opened->header(), data).select();
  if (data.definitions.empty()) {
    return tl::unexpected(HistoryError{
        HistoryError::Kind::kInput, shown_name, 0, 0,
        "has no friction force to draw (a result of 'slipbench run' has a line '# friction:')"});
  }
  std::vector<std::string> names;
  for (const PlotColumn& column : data.columns) names.push_back(column.name);
  auto reader = CsvReader::open(file, names, shown_name);
  if (!reader) return tl::unexpected(std::move(reader.error()));

  // First the ranges, then the rows: the pieces of time need to know the end.
  std::vector<double> row(names.size());
  data.lowest.assign(names.size(), std::numeric_limits<double>::infinity());
  data.highest.assign(names.size(), -std::numeric_limits<double>::infinity());
  long count = 0;
  while (true) {
    auto more = reader->next(row);
    if (!more) return tl::unexpected(std::move(more.error()));
    if (!*more) break;
    ++count;
    for (std::size_t k = 0; k < row.size(); ++k) {
      data.lowest[k] = std::min(data.lowest[k], row[k]);
      data.highest[k] = std::max(data.highest[k], row[k]);
    }
  }
  if (auto rewound = reader->rewind(); !rewound) return tl::unexpected(rewound.error());

  const double duration = data.highest[0] - data.lowest[0];
  const bool thin = count > 4L * buckets;
  const double width = duration / buckets;
  Bucket bucket(names.size());
  double bucket_end = data.lowest[0] + width;
  double before = data.lowest[0];
  for (long index = 0;; ++index) {
    auto more = reader->next(row);
    if (!more) return tl::unexpected(std::move(more.error()));
    if (!*more) break;
    for (PlotDefinition& definition : data.definitions) {
      if (definition.status < 0) continue;
      add_span(definition.spans,
               static_cast<int>(std::lround(row[static_cast<std::size_t>(definition.status)])),
               before, row[0], index > 0 ? 0.5 * width : 0.0);
    }
    before = row[0];
    if (!thin) {
      data.rows.insert(data.rows.end(), row.begin(), row.end());
      continue;
    }
    while (row[0] > bucket_end && bucket_end < data.highest[0]) {
      bucket.move_to(data.rows);
      bucket_end += width;
    }
    bucket.add(index, row);
  }
  bucket.move_to(data.rows);
  return data;
}

}  // namespace slipbench::driver
