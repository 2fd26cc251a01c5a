// SPDX-License-Identifier: Apache-2.0
#include "driver/mpi/mpi_farm.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <span>

namespace slipbench::driver::mpi {

MpiFarm::MpiFarm() {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
  const MPI_Aint bytes = rank_ == 0 ? sizeof(std::uint64_t) : 0;
  MPI_Win_allocate(bytes, sizeof(std::uint64_t), MPI_INFO_NULL, MPI_COMM_WORLD, &counter_,
                   &window_);
  MPI_Win_lock_all(MPI_MODE_NOCHECK, window_);
  if (rank_ == 0) *counter_ = 0;
  MPI_Win_sync(window_);
  MPI_Barrier(MPI_COMM_WORLD);
  int threads = MPI_THREAD_SINGLE;
  MPI_Query_thread(&threads);
  if (rank_ != 0 || ranks_ == 1 || threads < MPI_THREAD_SERIALIZED) return;
  // Where the network cannot add by itself, the others wait until rank 0 calls MPI; it runs samples
  // for longer than that.
  progress_ = std::thread([this] {
    constexpr std::chrono::microseconds kPause(200);
    while (!ended_.load()) {
      {
        const std::scoped_lock lock(calls_);
        int any = 0;
        MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &any, MPI_STATUS_IGNORE);
      }
      std::this_thread::sleep_for(kPause);
    }
  });
}

MpiFarm::~MpiFarm() {
  // Until all are here, some may still add.
  MPI_Request request = MPI_REQUEST_NULL;
  {
    const std::scoped_lock lock(calls_);
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
  }
  wait(request);
  ended_.store(true);
  if (progress_.joinable()) progress_.join();
  MPI_Win_unlock_all(window_);
  MPI_Win_free(&window_);
}

void MpiFarm::wait(MPI_Request request) {
  // Not in one call: rank 0 has another thread that must come to MPI meanwhile, and the cores may
  // be those of ranks that still run samples.
  constexpr std::chrono::microseconds kPause(100);
  while (true) {
    int done = 0;
    {
      const std::scoped_lock lock(calls_);
      MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    }
    if (done != 0) return;
    std::this_thread::sleep_for(kPause);
  }
}

std::uint64_t MpiFarm::advance(std::uint64_t count) {
  const std::scoped_lock lock(calls_);
  std::uint64_t before = 0;
  MPI_Fetch_and_op(&count, &before, MPI_UINT64_T, 0, 0, MPI_SUM, window_);
  MPI_Win_flush(0, window_);
  return before;
}

bool MpiFarm::agree(bool own) {
  const int mine = own ? 1 : 0;
  int all = 0;
  MPI_Request request = MPI_REQUEST_NULL;
  {
    const std::scoped_lock lock(calls_);
    MPI_Iallreduce(&mine, &all, 1, MPI_INT, MPI_LAND, MPI_COMM_WORLD, &request);
  }
  wait(request);
  return all != 0;
}

std::vector<double> MpiFarm::gather(std::span<const double> own) {
  const auto ranks = static_cast<std::size_t>(ranks_);
  const int count = static_cast<int>(own.size());
  std::vector<int> counts(ranks);
  std::vector<int> places(ranks);
  MPI_Request request = MPI_REQUEST_NULL;
  {
    const std::scoped_lock lock(calls_);
    MPI_Iallgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, MPI_COMM_WORLD, &request);
  }
  wait(request);
  for (std::size_t r = 1; r < ranks; ++r) places[r] = places[r - 1] + counts[r - 1];
  std::vector<double> all(static_cast<std::size_t>(places.back()) +
                          static_cast<std::size_t>(counts.back()));
  {
    const std::scoped_lock lock(calls_);
    MPI_Iallgatherv(own.data(), count, MPI_DOUBLE, all.data(), counts.data(), places.data(),
                    MPI_DOUBLE, MPI_COMM_WORLD, &request);
  }
  wait(request);
  return all;
}

farm::Farm MpiFarm::farm() {
  farm::Farm farm;
  farm.rank = static_cast<std::size_t>(rank_);
  farm.ranks = static_cast<std::size_t>(ranks_);
  farm.advance = [this](std::uint64_t count) { return advance(count); };
  farm.agree = [this](bool own) { return agree(own); };
  farm.gather = [this](std::span<const double> own) { return gather(own); };
  farm.restart = [this] {
    // All have asked for the last time before, and none asks before it is done.
    agree(true);
    if (rank_ == 0) {
      const std::scoped_lock lock(calls_);
      const std::uint64_t none = 0;
      std::uint64_t before = 0;
      MPI_Fetch_and_op(&none, &before, MPI_UINT64_T, 0, 0, MPI_REPLACE, window_);
      MPI_Win_flush(0, window_);
    }
    agree(true);
  };
  farm.share = [this](std::span<char> bytes) {
    // A count is an int: so many at once.
    constexpr std::size_t kMost = std::size_t{1} << 28;
    for (std::size_t i = 0; i < bytes.size(); i += kMost) {
      const std::span<char> some = bytes.subspan(i, std::min(kMost, bytes.size() - i));
      MPI_Request request = MPI_REQUEST_NULL;
      {
        const std::scoped_lock lock(calls_);
        MPI_Ibcast(some.data(), static_cast<int>(some.size()), MPI_CHAR, 0, MPI_COMM_WORLD,
                   &request);
      }
      wait(request);
    }
  };
  return farm;
}

}  // namespace slipbench::driver::mpi
