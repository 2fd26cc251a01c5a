// SPDX-License-Identifier: Apache-2.0
// Element sets of an Abaqus deck, and the names that an element goes by.
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/import/abaqus/keyword_deck.hpp"

namespace slipbench::driver::abaqus {

/// Sets of elements that a connector's section, a step or another of these sets names: most of the
/// sets of a deck are of the mesh. Labels are as label_of() has them.
class ElementSets {
 public:
  /// Reads them; what is wrong is reported to the deck.
  explicit ElementSets(const KeywordDeck& deck);

  /// Reports the name of a set that is not there: what it is named for would be lost.
  void expect(const std::string& label, std::string_view where, const Block& block) const;

  /// Adds the sets that have an element of a part (empty: of the assembly), and those that have one
  /// of `labels` as a member.
  void add_sets_of(const std::string& part, long number, std::set<std::string>& labels) const;

  /// The same of the assembly's sets and an element of one instance.
  void add_sets_of_instance(const std::string& instance, long number,
                            std::set<std::string>& labels) const;

 private:
  /// Label of a set, and the part in which it is stated.
  struct Scoped {
    std::string part;
    std::string label;
  };
  /// Numbers of a set with GENERATE.
  struct Range {
    std::string label;
    long first = 0, last = 0, step = 1;
    const Block* block = nullptr;  ///< it is stated by
    long furthest = 0;  ///< last number of those around which this one stands in the middle
    bool has(long number) const {
      return number >= first && number <= last && (number - first) % step == 0;
    }
  };

  void want(const std::string& label);
  void read(const std::string& part, const Block& block);
  void put_in_order(std::vector<Range>& ranges) const;
  static long note_furthest(std::span<Range> ranges);
  static void add_around(long number, std::span<const Range> ranges, std::set<std::string>& labels);
  template <class Accepts>
  void add_holders(std::set<std::string>& labels, const Accepts& accepts) const;

  const KeywordDeck& deck_;
  std::set<std::string> labels_;  ///< of all sets of elements
  bool is_open_ = false;          ///< keywords that are not read make sets, too
  std::set<std::string> wanted_;
  std::vector<std::string> unread_;                     ///< of these
  std::map<std::string, std::vector<Scoped>> holders_;  ///< of a member, the sets that have it
  std::map<std::string, std::vector<Range>> of_part_;   ///< by the part they are stated in
  std::map<std::string, std::vector<Range>> of_instance_;
};

}  // namespace slipbench::driver::abaqus
