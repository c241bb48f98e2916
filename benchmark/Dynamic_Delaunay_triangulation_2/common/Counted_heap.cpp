// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A file of its own, because the functions that replace `operator new` and `operator delete` must
// not be inline.

#include "Counted_heap.h"

#include <atomic>
#include <cstdlib>
#include <malloc.h> // malloc_usable_size()
#include <new>

namespace {

std::atomic<std::size_t> live_bytes{0};
std::atomic<std::size_t> peak_bytes{0};
std::atomic<std::size_t> allocations{0};

void* counted(void* memory)
{
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  allocations.fetch_add(1, std::memory_order_relaxed);
  const std::size_t bytes = malloc_usable_size(memory);
  const std::size_t live = live_bytes.fetch_add(bytes, std::memory_order_relaxed) + bytes;
  std::size_t peak = peak_bytes.load(std::memory_order_relaxed);
  while (peak < live && !peak_bytes.compare_exchange_weak(peak, live, std::memory_order_relaxed)) {
  }
  return memory;
}

void give_back(void* memory)
{
  live_bytes.fetch_sub(malloc_usable_size(memory), std::memory_order_relaxed);
  std::free(memory);
}

} // namespace

namespace common {

std::size_t live_heap_bytes()
{
  return live_bytes.load(std::memory_order_relaxed);
}

std::size_t number_of_allocations()
{
  return allocations.load(std::memory_order_relaxed);
}

std::size_t peak_heap_bytes()
{
  return peak_bytes.load(std::memory_order_relaxed);
}

void start_peak()
{
  peak_bytes.store(live_heap_bytes(), std::memory_order_relaxed);
}

} // namespace common

// The other forms, for arrays and without exceptions, call these.

void* operator new(std::size_t size)
{
  return counted(std::malloc(size));
}

void* operator new(std::size_t size, std::align_val_t alignment)
{
  const auto unit = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(unit, (size + unit - 1) / unit * unit));
}

void operator delete(void* memory) noexcept
{
  give_back(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  give_back(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept
{
  give_back(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
  give_back(memory);
}
