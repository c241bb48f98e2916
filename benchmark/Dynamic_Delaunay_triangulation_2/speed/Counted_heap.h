// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_COUNTED_HEAP_H
#define SPEED_COUNTED_HEAP_H

#include <cstddef>

namespace speed {

// What this program has allocated by `operator new` and not given back, as large as the blocks
// really are.
std::size_t live_heap_bytes();

// How often it has allocated so far.
std::size_t number_of_allocations();

} // namespace speed

#endif // SPEED_COUNTED_HEAP_H
