// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mpi.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

#include "driver/farm/run_farm.hpp"

namespace slipbench::driver::mpi {

/// All ranks of an MPI program as a farm. Its counter is a number in the memory of rank 0, to which
/// every rank adds by itself (MPI_Fetch_and_op), so that no rank is spent on handing out work.
class MpiFarm {
 public:
  MpiFarm();
  ~MpiFarm();
  MpiFarm(const MpiFarm&) = delete;
  MpiFarm& operator=(const MpiFarm&) = delete;

  /// Refers to this.
  farm::Farm farm();

 private:
  std::uint64_t advance(std::uint64_t count);
  bool agree(bool own);
  std::vector<double> gather(std::span<const double> own);
  /// Waits until an operation is done.
  void wait(MPI_Request request);

  int rank_ = 0;
  int ranks_ = 1;
  std::uint64_t* counter_ = nullptr;
  MPI_Win window_ = MPI_WIN_NULL;
  std::mutex calls_;  ///< of MPI, from one thread at a time
  std::atomic<bool> ended_{false};
  std::thread progress_;
};

}  // namespace slipbench::driver::mpi
