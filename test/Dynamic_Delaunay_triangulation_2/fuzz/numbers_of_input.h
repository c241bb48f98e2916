// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Random numbers that a fuzzer chooses.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_FUZZ_NUMBERS_OF_INPUT_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_FUZZ_NUMBERS_OF_INPUT_H

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

namespace fuzz {

// Two bytes of the input are the first bits of a number. The other bits, and numbers after the end,
// are random, since distributions may draw as many as they like.
class Numbers_of_input
{
public:
  using result_type = std::uint64_t;

  explicit Numbers_of_input(const std::string& input)
    : m_input(input)
  {
  }

  static constexpr result_type(min)() { return 0; }
  static constexpr result_type(max)() { return ~result_type(0); }

  result_type operator()()
  {
    result_type number = m_others();
    if (m_place + 2 <= m_input.size()) {
      number = byte() << 56 | byte() << 48 | number >> 16;
    }
    return number;
  }

  std::uint64_t byte()
  {
    return m_place < m_input.size() ? static_cast<unsigned char>(m_input[m_place++]) : 0;
  }

private:
  std::string m_input;
  std::size_t m_place = 0;
  std::mt19937_64 m_others{1};
};

} // namespace fuzz

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_FUZZ_NUMBERS_OF_INPUT_H
