// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMON_COUNTED_HEAP_H
#define COMMON_COUNTED_HEAP_H

#include <cstddef>

namespace common {

// What this program has allocated by `operator new` and not given back, as large as the blocks
// really are.
std::size_t live_heap_bytes();

// How often it has allocated so far.
std::size_t number_of_allocations();

// The most that it has had at a time since the last call of start_peak(), or of its start.
std::size_t peak_heap_bytes();
void start_peak();

} // namespace common

#endif // COMMON_COUNTED_HEAP_H
