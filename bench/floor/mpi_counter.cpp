// SPDX-License-Identifier: Apache-2.0
// Times the counter of the farm: every rank adds to a number of rank 0 as often as it can.
// usage: mpicxx -O2 bench/floor/mpi_counter.cpp -o mpi_counter && mpirun -n N mpi_counter
#include <mpi.h>

#include <cstdint>
#include <cstdio>

int main(int argc, char** argv) {
  constexpr int kTimes = 200'000;
  MPI_Init(&argc, &argv);
  int rank = 0;
  int ranks = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  std::uint64_t* counter = nullptr;
  MPI_Win window = MPI_WIN_NULL;
  MPI_Win_allocate(rank == 0 ? sizeof *counter : 0, sizeof *counter, MPI_INFO_NULL, MPI_COMM_WORLD,
                   &counter, &window);
  MPI_Win_lock_all(0, window);
  if (rank == 0) *counter = 0;
  MPI_Win_sync(window);
  MPI_Barrier(MPI_COMM_WORLD);
  const double begin = MPI_Wtime();
  std::uint64_t before = 0;
  for (int i = 0; i < kTimes; ++i) {
    const std::uint64_t one = 1;
    MPI_Fetch_and_op(&one, &before, MPI_UINT64_T, 0, 0, MPI_SUM, window);
    MPI_Win_flush(0, window);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  const double seconds = MPI_Wtime() - begin;
  const bool right = rank != 0 || *counter == static_cast<std::uint64_t>(kTimes) * ranks;
  if (rank == 0) {
    std::printf("%d ranks: %.3g us a question, %.3g million answers a second\n", ranks,
                seconds / kTimes * 1e6, kTimes * 1e-6 * ranks / seconds);
  }
  MPI_Win_unlock_all(window);
  MPI_Win_free(&window);
  MPI_Finalize();
  return right ? 0 : 1;
}
