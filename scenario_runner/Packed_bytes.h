// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_PACKED_BYTES_H
#define SCENARIO_RUNNER_PACKED_BYTES_H

#include <cstddef>
#include <cstdint>
#include <string>

namespace run {

// Integers as bytes, small ones as few: seven bits in each, the lowest first, all but the last one
// of a number with the eighth bit set (LEB128). The sign of a number with a sign is its lowest bit.
class Packed_bytes
{
public:
  void append(std::uint64_t number)
  {
    for (; number >= 128; number >>= 7) {
      m_bytes += static_cast<char>(number | 128);
    }
    m_bytes += static_cast<char>(number);
  }

  void append_signed(std::int64_t number)
  {
    const auto bits = static_cast<std::uint64_t>(number) << 1;
    append(number < 0 ? ~bits : bits);
  }

  const std::string& bytes() const { return m_bytes; }

private:
  std::string m_bytes;
};

// Text of four letters for every three bytes (RFC 4648).
inline std::string base64(const std::string& bytes)
{
  constexpr const char* const letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k != 3; ++k) {
      const char byte = i + k < bytes.size() ? bytes[i + k] : '\0';
      three = three << 8 | static_cast<unsigned char>(byte);
    }
    for (std::size_t k = 0; k != 4; ++k) {
      const bool is_there = i + k <= bytes.size();
      text += is_there ? letters[three >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

} // namespace run

#endif // SCENARIO_RUNNER_PACKED_BYTES_H
