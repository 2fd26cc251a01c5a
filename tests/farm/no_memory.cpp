// SPDX-License-Identifier: Apache-2.0
// Preloaded, it refuses memory once to rank 1 of an MPI job: when there is something in the journal
// that NO_MEMORY_AFTER names.
#include <sys/stat.h>

#include <cstdlib>
#include <cstring>
#include <new>

namespace {

constexpr off_t kRecords = 1000;  ///< bytes of a journal that has more than its head

bool refuses() {
  static bool refused = false;
  const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
  const char* journal = std::getenv("NO_MEMORY_AFTER");
  if (refused || rank == nullptr || journal == nullptr || std::strcmp(rank, "1") != 0) return false;
  struct stat state {};
  refused = stat(journal, &state) == 0 && state.st_size > kRecords;
  return refused;
}

}  // namespace

void* operator new(std::size_t size) {
  void* memory = refuses() ? nullptr : std::malloc(size > 0 ? size : 1);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
