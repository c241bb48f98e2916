// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The heap of a whole program, which counts and can run out. It replaces `operator new` and
// `operator delete`, whose definitions must not be inline: one file of a program includes it.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_REPLACED_HEAP_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_REPLACED_HEAP_H

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace replaced_heap {

// What a thread does to the heap is its own affair: others neither count with it nor fail with it.
inline thread_local std::size_t number_of_allocations = 0;
inline thread_local std::size_t largest_allocation = 0;   // in bytes, since a test has set it to 0
inline thread_local long number_of_allocations_left = -1; // negative: as many as one likes

// As long as it lives, the memory of this thread runs out after so many allocations, once.
class Scarcity
{
public:
  explicit Scarcity(long allocations) { number_of_allocations_left = allocations; }
  Scarcity(const Scarcity&) = delete;
  Scarcity& operator=(const Scarcity&) = delete;
  ~Scarcity() { number_of_allocations_left = -1; }
};

inline void count(std::size_t size)
{
  ++number_of_allocations;
  largest_allocation = (std::max)(largest_allocation, size);
}

inline bool runs_out()
{
  return number_of_allocations_left >= 0 && number_of_allocations_left-- == 0;
}

// Null if there is no memory.
inline void* allocated(std::size_t size) noexcept
{
  count(size);
  return runs_out() ? nullptr : std::malloc(std::max<std::size_t>(size, 1));
}

inline void* allocated(std::size_t size, std::align_val_t alignment) noexcept
{
  count(size);
  const auto unit = static_cast<std::size_t>(alignment);
  const std::size_t units = std::max<std::size_t>(size / unit + (size % unit != 0), 1);
  return runs_out() ? nullptr : std::aligned_alloc(unit, units * unit);
}

inline void* or_throw(void* memory)
{
  if (memory == nullptr)
    throw std::bad_alloc();
  return memory;
}

} // namespace replaced_heap

// Where memory runs out, CGAL's container loses the block that it has just got.
extern "C" const char* __lsan_default_suppressions();
extern "C" [[gnu::noinline]] const char* __lsan_default_suppressions()
{
  return "leak:CGAL::Compact_container*allocate_new_block";
}

// All forms are replaced, because the address sanitizer provides the others, and reports memory
// that one of its forms allocates and one of these frees. (Inlined, they would draw a false warning
// about mismatched allocation from g++.)

[[gnu::noinline]] void* operator new(std::size_t size)
{
  return replaced_heap::or_throw(replaced_heap::allocated(size));
}

[[gnu::noinline]] void* operator new[](std::size_t size)
{
  return replaced_heap::or_throw(replaced_heap::allocated(size));
}

[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  return replaced_heap::allocated(size);
}

[[gnu::noinline]] void* operator new[](std::size_t size, const std::nothrow_t&) noexcept
{
  return replaced_heap::allocated(size);
}

[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment)
{
  return replaced_heap::or_throw(replaced_heap::allocated(size, alignment));
}

[[gnu::noinline]] void* operator new[](std::size_t size, std::align_val_t alignment)
{
  return replaced_heap::or_throw(replaced_heap::allocated(size, alignment));
}

[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment,
                                     const std::nothrow_t&) noexcept
{
  return replaced_heap::allocated(size, alignment);
}

[[gnu::noinline]] void* operator new[](std::size_t size, std::align_val_t alignment,
                                       const std::nothrow_t&) noexcept
{
  return replaced_heap::allocated(size, alignment);
}

[[gnu::noinline]] void operator delete(void* memory) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete[](void* memory) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete[](void* memory, std::size_t) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, const std::nothrow_t&) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete[](void* memory, const std::nothrow_t&) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete[](void* memory, std::align_val_t) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::align_val_t,
                                       const std::nothrow_t&) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete[](void* memory, std::align_val_t,
                                         const std::nothrow_t&) noexcept
{
  std::free(memory);
}

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_REPLACED_HEAP_H
