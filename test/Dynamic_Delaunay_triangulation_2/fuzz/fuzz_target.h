// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Turns a fuzz_*.cpp, which includes this header and defines fuzz::examine(), into a fuzz target.
// Built with libFuzzer (FUZZ_WITH_LIBFUZZER) the program searches for findings; else its main()
// replays files and a fixed number of mutations of them.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_FUZZ_TARGET_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_FUZZ_TARGET_H

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace fuzz {

// Takes any bytes. Whatever it throws is a finding, and so is a crash, a hang, or a report of a
// sanitizer.
void examine(const std::string& input);

class Finding : public std::logic_error
{
public:
  using std::logic_error::logic_error;
};

inline void require(bool is_true, const char* what)
{
  if (!is_true) {
    throw Finding(what);
  }
}

} // namespace fuzz

// An exception ends the program here, with its message; libFuzzer keeps the input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) noexcept
{
  fuzz::examine(std::string(data, data + size));
  return 0;
}

#ifndef FUZZ_WITH_LIBFUZZER
#include "replay.h"

int main(int argc, char** argv)
{
  return fuzz::replay(argc, argv);
}
#endif

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_FUZZ_TARGET_H
