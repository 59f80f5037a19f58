#include "memory_meter.h"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace {

std::size_t held = 0, most = 0;  // the tests here run in one thread

void* take(std::size_t size) {
  void* memory = std::malloc(size > 0 ? size : 1);
  if (!memory) std::abort();
  held += malloc_usable_size(memory);
  most = std::max(most, held);
  return memory;
}

void give_back(void* memory) {
  if (!memory) return;
  held -= malloc_usable_size(memory);
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) { return take(size); }
void* operator new[](std::size_t size) { return take(size); }
void operator delete(void* memory) noexcept { give_back(memory); }
void operator delete[](void* memory) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t) noexcept { give_back(memory); }
void operator delete[](void* memory, std::size_t) noexcept { give_back(memory); }

namespace cromer::core {

std::size_t most_bytes_held(FunctionRef<void()> call) {
  const std::size_t before = held;
  most = held;
  call();
  return most - before;
}

}  // namespace cromer::core
