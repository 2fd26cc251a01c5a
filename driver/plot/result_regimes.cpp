// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/result_regimes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/base/csv/comment_lines.hpp"
#include "driver/base/files/regular_file.hpp"
#include "driver/base/text/number.hpp"
#include "driver/base/text/source_text.hpp"
#include "driver/results/events.hpp"
#include "driver/results/result_layout.hpp"
#include "driver/results/run_files.hpp"
#include "driver/yaml/parse.hpp"

namespace slipbench::driver::plot {
namespace {

namespace fs = std::filesystem;

struct EventLine {
  double time = 0.0;
  std::string definition;
  int from = 1;
  int to = 1;
};

std::optional<int> status_of(std::string_view regime) {
  constexpr std::array<std::string_view, 3> kNames{"open", "stick", "slip"};
  const auto found = std::find(kNames.begin(), kNames.end(), regime);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<int>(found - kNames.begin());
}

std::optional<EventLine> read_event(std::string_view line) {
  std::array<std::string_view, 4> fields;
  for (std::string_view& field : fields) {
    const std::size_t end = line.find(',');
    if (end == std::string_view::npos) return std::nullopt;
    field = line.substr(0, end);
    line.remove_prefix(end + 1);
  }
  const auto time = base::parse_number(fields[0]);
  const auto from = status_of(fields[2]);
  const auto to = status_of(fields[3]);
  if (!time || !from || !to) return std::nullopt;
  return EventLine{*time, std::string(fields[1]), *from, *to};
}

/// The regimes by a file of events; nothing if it is none, or of another run.
std::optional<std::vector<results::RegimeHistory>> read_events(const fs::path& file,
                                                               const fs::path& result,
                                                               const results::PlotData& data) {
  const auto comments = base::comment_lines(result);
  const std::set<std::string> known(comments.begin(), comments.end());
  auto in = base::open_regular(file);
  if (!in) return std::nullopt;
  std::map<std::string, std::size_t, std::less<>> places;
  for (std::size_t d = 0; d < data.definitions.size(); ++d) {
    places.emplace(data.definitions[d].name, d);
  }
  const double start = data.lowest[0];
  const double end = data.highest[0];
  std::vector<results::RegimeRecorder> regimes(data.definitions.size());
  std::vector<bool> begun(data.definitions.size());
  bool header = false;
  double before = start;
  for (std::string line; std::getline(*in, line);) {
    if (in->eof()) return std::nullopt;  // cut off
    if (line.ends_with('\r')) line.pop_back();
    if (line.starts_with('#')) {
      if (!known.contains(line)) return std::nullopt;
      continue;
    }
    if (!header) {
      if (!line.starts_with("t,definition,from,to,")) return std::nullopt;
      header = true;
      continue;
    }
    if (line.find(std::string(",slip,") + results::kJumpWord + ",") != std::string::npos) continue;
    const auto event = read_event(line);
    if (!event || event->time < before || event->time > end) return std::nullopt;
    before = event->time;
    const auto place = places.find(event->definition);
    if (place == places.end()) continue;  // one that has no column to be drawn
    const std::size_t d = place->second;
    if (!begun[d]) regimes[d].begin(event->from, start);
    begun[d] = true;
    regimes[d].change(event->to, event->time);
  }
  if (!header) return std::nullopt;
  std::vector<results::RegimeHistory> histories;
  for (std::size_t d = 0; d < regimes.size(); ++d) {
    // Without an event it stays as it began, which its rows tell.
    histories.push_back(begun[d] ? regimes[d].end(end) : data.definitions[d].regimes);
  }
  return histories;
}

/// Takes the sums of a summary where its count of slips is that of the events.
void take_sums(const yaml::Node& summary, results::PlotData& data) {
  const auto list = summary.find("definitions");
  if (!list) return;
  std::map<std::string_view, results::RegimeHistory*> histories;
  for (results::PlotDefinition& one : data.definitions) histories.emplace(one.name, &one.regimes);
  for (const yaml::Node node : list->items()) {
    const auto number = [&](std::string_view key) -> std::optional<double> {
      const auto member = node.find(key);
      if (!member || !member->is_scalar()) return std::nullopt;
      const auto value = base::parse_number(member->text());
      return value ? std::optional(*value) : std::nullopt;
    };
    const auto name = node.find("name");
    if (!name || !name->is_scalar()) continue;
    const auto own = histories.find(name->text());
    if (own == histories.end()) continue;
    results::RegimeHistory& history = *own->second;
    const auto slip = number("slip_time");
    const auto open = number("open_time");
    const auto begins = number("stick_slip_events");
    const auto reversals = number("reversals");
    if (!slip || !open || !begins || !reversals) continue;
    if (std::llround(*begins) != history.slip_begins) continue;
    history.slip_time = *slip;
    history.open_time = *open;
    history.reversals = std::llround(*reversals);
  }
}

}  // namespace

bool take_events_beside(const fs::path& result, results::PlotData& data) {
  const fs::path events = fs::path(result).replace_extension(".events.csv");
  // JSON is YAML; the reader of cases is strict and has its limits.
  const auto source = base::read_source(fs::path(result).replace_extension(".json").string());
  std::optional<yaml::Tree> json;
  if (source) {
    if (auto tree = yaml::parse_yaml(*source)) json.emplace(std::move(*tree));
  }
  if (json &&
      !(results::is_listed(json->root(), result) && results::is_listed(json->root(), events)))
    return false;
  auto histories = read_events(events, result, data);
  if (!histories) return false;
  for (std::size_t d = 0; d < histories->size(); ++d) {
    data.definitions[d].regimes = std::move((*histories)[d]);
  }
  if (!json) return true;
  if (const auto summary = json->root().find("summary")) take_sums(*summary, data);
  return true;
}

}  // namespace slipbench::driver::plot
