// SPDX-License-Identifier: Apache-2.0
#include "driver/results/thinning.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace slipbench::driver::results {

RowThinner::RowThinner(std::size_t columns, std::size_t limit, std::span<const std::size_t> watched)
    : columns_(columns), all_(columns), watched_(watched.begin(), watched.end()) {
  std::iota(all_.begin(), all_.end(), std::size_t{0});
  if (watched_.empty()) watched_ = all_;
  const std::size_t least = 2 + 2 * columns_ + 2 * watched_.size();
  limit_ = std::max(limit, least + (least + 2) / 3);
  most_kept_ = limit_ / 4;
}

void RowThinner::Rows::clear() {
  index.clear();
  numbers.clear();
}

std::span<const double> RowThinner::row_of(const Rows& rows, std::size_t i) const {
  return {rows.numbers.data() + i * columns_, columns_};
}

void RowThinner::append(Rows& to, const Rows& from, std::size_t i) const {
  const std::span<const double> row = row_of(from, i);
  to.index.push_back(from.index[i]);
  to.numbers.insert(to.numbers.end(), row.begin(), row.end());
}

void RowThinner::choose(const Rows& rows, std::size_t begin, std::size_t end,
                        std::span<const std::size_t> columns, Chosen& chosen) const {
  if (begin == end) return;
  chosen.push_back(begin);
  chosen.push_back(end - 1);
  for (const std::size_t c : columns) {
    // A number that compares with nothing must not stay the extreme it happened to begin as.
    const auto number = [&](std::size_t i) { return rows.numbers[i * columns_ + c]; };
    std::size_t first = begin;
    while (first < end && !(number(first) == number(first))) ++first;
    if (first == end) continue;
    std::size_t lowest = first;
    std::size_t highest = first;
    for (std::size_t i = first + 1; i < end; ++i) {
      if (number(i) < number(lowest)) lowest = i;
      if (number(i) > number(highest)) highest = i;
    }
    chosen.push_back(lowest);
    chosen.push_back(highest);
  }
}

namespace {

void sort_unique(std::vector<std::size_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

void RowThinner::close_piece() {
  if (open_.size() == 1) {
    append(done_, open_, 0);
  } else {
    Chosen chosen;
    choose(open_, 0, open_.size(), all_, chosen);
    sort_unique(chosen);
    for (const std::size_t i : chosen) append(done_, open_, i);
  }
  open_.clear();
  in_piece_ = 0;
  piece_ends_.push_back(done_.size());
  if (piece_ends_.size() > limit_) merge_pieces();
}

/// Two neighbours become one: the extremes of both are among the extremes of each.
void RowThinner::merge_pieces() {
  Rows merged;
  std::vector<std::size_t> ends;
  Chosen chosen;
  std::size_t begin = 0;
  std::size_t p = 1;
  for (; p < piece_ends_.size(); p += 2) {
    chosen.clear();
    choose(done_, begin, piece_ends_[p], all_, chosen);
    sort_unique(chosen);
    for (const std::size_t i : chosen) append(merged, done_, i);
    ends.push_back(merged.size());
    begin = piece_ends_[p];
  }
  // An odd one at the end is half of a piece that goes on.
  for (std::size_t i = begin; i < done_.size(); ++i) append(open_, done_, i);
  if (begin < done_.size()) in_piece_ = piece_length_;
  piece_length_ *= 2;
  done_ = std::move(merged);
  piece_ends_ = std::move(ends);
}

void RowThinner::keep(std::span<const double> row) {
  if (wanted_++ % keep_every_ != 0) return;
  kept_.index.push_back(count_);
  kept_.numbers.insert(kept_.numbers.end(), row.begin(), row.end());
  if (kept_.size() <= most_kept_) return;
  Rows fewer;
  for (std::size_t i = 0; i < kept_.size(); i += 2) append(fewer, kept_, i);
  kept_ = std::move(fewer);
  keep_every_ *= 2;
}

void RowThinner::add(std::span<const double> row, bool must_keep) {
  if (must_keep) keep(row);
  open_.index.push_back(count_++);
  open_.numbers.insert(open_.numbers.end(), row.begin(), row.end());
  if (++in_piece_ >= piece_length_) {
    close_piece();
    return;
  }
  const std::size_t most_open = 4 * (columns_ + 1);
  if (open_.size() < 2 * most_open) return;
  Chosen chosen;
  choose(open_, 0, open_.size(), all_, chosen);
  sort_unique(chosen);
  Rows fewer;
  for (const std::size_t i : chosen) append(fewer, open_, i);
  open_ = std::move(fewer);
}

RowThinner::Rows RowThinner::indexed_rows(std::size_t most) const {
  Rows all = done_;
  std::vector<std::size_t> ends = piece_ends_;
  if (open_.size() > 0) {
    for (std::size_t i = 0; i < open_.size(); ++i) append(all, open_, i);
    ends.push_back(all.size());
  }
  if (!thinned()) return all;

  // The rows that stay whatever the pieces; those the caller wants may be gone from the pieces.
  Chosen always;
  choose(all, 0, all.size(), all_, always);
  std::vector<std::int64_t> fixed = kept_.index;
  for (const std::size_t i : always) fixed.push_back(all.index[i]);

  const auto chosen_of = [&](std::size_t groups) {
    Chosen chosen;
    std::size_t begin = 0;
    for (std::size_t g = 1; g <= groups; ++g) {
      const std::size_t end = ends[g * ends.size() / groups - 1];
      choose(all, begin, end, watched_, chosen);
      begin = end;
    }
    std::vector<std::int64_t> index = fixed;
    for (const std::size_t i : chosen) index.push_back(all.index[i]);
    std::sort(index.begin(), index.end());
    index.erase(std::unique(index.begin(), index.end()), index.end());
    return index;
  };
  // A piece of its own for every row cannot fit; the count falls about as the number of pieces.
  std::size_t groups = ends.size();
  std::vector<std::int64_t> index = chosen_of(groups);
  while (index.size() > most && groups > 1) {
    const std::size_t next = groups * most / index.size();
    groups = std::max<std::size_t>(1, std::min(next, groups - 1));
    index = chosen_of(groups);
  }

  Rows rows;
  rows.numbers.reserve(index.size() * columns_);
  std::size_t from_all = 0;
  std::size_t from_kept = 0;
  for (const std::int64_t i : index) {
    while (from_all < all.size() && all.index[from_all] < i) ++from_all;
    while (from_kept < kept_.size() && kept_.index[from_kept] < i) ++from_kept;
    const bool in_pieces = from_all < all.size() && all.index[from_all] == i;
    const std::span<const double> row =
        in_pieces ? row_of(all, from_all) : row_of(kept_, from_kept);
    rows.numbers.insert(rows.numbers.end(), row.begin(), row.end());
  }
  rows.index = std::move(index);
  return rows;
}

}  // namespace slipbench::driver::results
