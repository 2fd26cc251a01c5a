// SPDX-License-Identifier: Apache-2.0
#include "driver/import/abaqus/element_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>

namespace slipbench::driver::abaqus {
namespace {

/// Most ranges around a number: they are looked at one by one for each element with a connector.
constexpr std::size_t kMostAround = 1000;

/// "PIN" of "ARM-1.PIN".
std::string own_part(const std::string& label) { return label.substr(label.rfind('.') + 1); }

bool starts_with_digit(const std::string& text) {
  return !text.empty() && text.front() >= '0' && text.front() <= '9';
}

}  // namespace

ElementSets::ElementSets(const KeywordDeck& deck) : deck_(deck) {
  std::map<std::string, std::vector<std::pair<std::string, const Block*>>> stated;
  std::string part;
  for (const Block& block : deck.blocks()) {
    const std::string set = label_of(block.value_of("ELSET"));
    if (block.keyword == "PART") {
      part = label_of(block.value_of("NAME"));
    } else if (block.keyword == "END PART") {
      part.clear();
    } else if (block.keyword == "ELSET") {
      stated[set].emplace_back(part, &block);
      labels_.insert(set);
    } else if (block.keyword == "ELEMENT") {
      labels_.insert(set);
    } else if (block.keyword == "ELGEN" || block.keyword == "ELCOPY" || block.keyword == "IMPORT" ||
               block.keyword == "RESTART") {
      is_open_ = true;
    } else if (block.keyword == "CONNECTOR SECTION" || block.keyword == "CHANGE FRICTION") {
      want(set);
    } else if (block.keyword == "CONNECTOR MOTION" || block.keyword == "CONNECTOR LOAD") {
      deck.for_each_line(block, [&](std::string_view line) {
        const Items items = split_items(line);
        want(label_of(items.front()));
      });
    }
  }
  while (!unread_.empty()) {
    const auto sets = stated.find(unread_.back());
    unread_.pop_back();
    if (sets == stated.end()) continue;
    for (const auto& [of_part, block] : sets->second) read(of_part, *block);
  }
  for (auto& [name, ranges] : of_part_) put_in_order(ranges);
  for (auto& [name, ranges] : of_instance_) put_in_order(ranges);
}

/// Notes that a set is to be read, one of an instance by its name in the part, too.
void ElementSets::want(const std::string& label) {
  for (const std::string& one : {label, own_part(label)}) {
    if (wanted_.insert(one).second) unread_.push_back(one);
  }
}

void ElementSets::read(const std::string& part, const Block& block) {
  const std::string label = label_of(block.value_of("ELSET"));
  // Members in an instance are counted as those of its part.
  const std::string instance = label_of(block.value_of("INSTANCE"));
  std::vector<Range>& ranges = instance.empty() ? of_part_[part] : of_instance_[instance];
  std::vector<std::string> members;
  const bool generate = block.has("GENERATE");
  for (const Items& items : deck_.lines(block)) {
    if (generate) {
      const long first = deck_.whole(items.front(), 0);
      const long last = items.size() > 1 ? deck_.whole(items[1], first) : first;
      const long step = items.size() > 2 ? deck_.whole(items[2], 0) : 1;
      if (step < 1) deck_.error(items[2], block, "wanted a whole number of 1 or more");
      ranges.push_back({label, first, last, std::max(1L, step), &block});
      continue;
    }
    for (const std::string_view item : items) {
      if (item.empty()) continue;
      members.push_back(instance.empty() ? label_of(item) : instance + "." + label_of(item));
    }
  }
  // A set of sets: those are wanted, too, wherever they stand.
  for (const std::string& member : members) {
    if (!starts_with_digit(own_part(member))) want(member);
    holders_[member].push_back({part, label});
  }
}

/// Joins ranges of one set that overlap or touch, and orders all by their first numbers, so that
/// those around a number are found without a look at the others. Reports where those are too many.
void ElementSets::put_in_order(std::vector<Range>& ranges) const {
  std::erase_if(ranges, [](const Range& one) { return one.last < one.first; });
  const auto remainder = [](const Range& one) {
    return (one.first % one.step + one.step) % one.step;
  };
  const auto is_series = [&](const Range& a, const Range& b) {
    return a.step == b.step && remainder(a) == remainder(b) && a.label == b.label;
  };
  std::sort(ranges.begin(), ranges.end(), [&](const Range& a, const Range& b) {
    return std::tuple(std::string_view(a.label), a.step, remainder(a), a.first) <
           std::tuple(std::string_view(b.label), b.step, remainder(b), b.first);
  });
  std::vector<Range> joined;
  for (Range& one : ranges) {
    one.last -= (one.last - one.first) % one.step;
    if (!joined.empty() && is_series(joined.back(), one) &&
        one.first <= joined.back().last + one.step) {
      joined.back().last = std::max(joined.back().last, one.last);
    } else {
      joined.push_back(std::move(one));
    }
  }
  ranges = std::move(joined);
  std::sort(ranges.begin(), ranges.end(),
            [](const Range& a, const Range& b) { return a.first < b.first; });
  std::priority_queue<long, std::vector<long>, std::greater<>> around;  // ends of them
  for (const Range& one : ranges) {
    while (!around.empty() && around.top() < one.first) around.pop();
    around.push(one.last);
    if (around.size() <= kMostAround) continue;
    deck_.error(one.block->where, *one.block,
                fmt::format("more than {} ranges of element sets lie around {}: state these sets "
                            "with fewer steps",
                            kMostAround, one.first));
    ranges.clear();
    return;
  }
  note_furthest(ranges);
}

long ElementSets::note_furthest(std::span<Range> ranges) {
  if (ranges.empty()) return std::numeric_limits<long>::min();
  const std::size_t middle = ranges.size() / 2;
  Range& one = ranges[middle];
  one.furthest = std::max(
      {one.last, note_furthest(ranges.first(middle)), note_furthest(ranges.subspan(middle + 1))});
  return one.furthest;
}

/// Adds the sets whose ranges have a number.
void ElementSets::add_around(long number, std::span<const Range> ranges,
                             std::set<std::string>& labels) {
  if (ranges.empty()) return;
  const std::size_t middle = ranges.size() / 2;
  const Range& one = ranges[middle];
  if (one.furthest < number) return;
  add_around(number, ranges.first(middle), labels);
  if (one.first > number) return;
  if (one.has(number)) labels.insert(one.label);
  add_around(number, ranges.subspan(middle + 1), labels);
}

void ElementSets::expect(const std::string& label, std::string_view where,
                         const Block& block) const {
  const std::string own = own_part(label);
  if (is_open_ || own.empty() || starts_with_digit(own) || labels_.count(own) > 0) return;
  deck_.error(where, block, "there is no element set of that name");
}

/// Adds the sets that have one of these as a member, and those that have these.
template <class Accepts>
void ElementSets::add_holders(std::set<std::string>& labels, const Accepts& accepts) const {
  std::vector<std::string> fresh(labels.begin(), labels.end());
  while (!fresh.empty()) {
    const auto holders = holders_.find(fresh.back());
    fresh.pop_back();
    if (holders == holders_.end()) continue;
    for (const Scoped& one : holders->second) {
      if (accepts(one) && labels.insert(one.label).second) fresh.push_back(one.label);
    }
  }
}

void ElementSets::add_sets_of(const std::string& part, long number,
                              std::set<std::string>& labels) const {
  if (const auto holders = holders_.find(std::to_string(number)); holders != holders_.end()) {
    for (const Scoped& one : holders->second) {
      if (one.part == part) labels.insert(one.label);
    }
  }
  if (const auto ranges = of_part_.find(part); ranges != of_part_.end()) {
    add_around(number, ranges->second, labels);
  }
  add_holders(labels, [](const Scoped&) { return true; });
}

void ElementSets::add_sets_of_instance(const std::string& instance, long number,
                                       std::set<std::string>& labels) const {
  if (const auto ranges = of_instance_.find(instance); ranges != of_instance_.end()) {
    add_around(number, ranges->second, labels);
  }
  add_holders(labels, [](const Scoped& holder) { return holder.part.empty(); });
}

}  // namespace slipbench::driver::abaqus
