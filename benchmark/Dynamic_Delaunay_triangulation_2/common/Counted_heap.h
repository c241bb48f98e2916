// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMON_COUNTED_HEAP_H
#define COMMON_COUNTED_HEAP_H

#include <cstddef>

namespace common {

// The bytes that this program has allocated by `operator new` and not freed, by the real sizes of
// blocks.
std::size_t live_heap_bytes();

// The number of allocations so far.
std::size_t number_of_allocations();

// The maximum of live_heap_bytes() since the last call of start_peak(), or since the start.
std::size_t peak_heap_bytes();
void start_peak();

} // namespace common

#endif // COMMON_COUNTED_HEAP_H
