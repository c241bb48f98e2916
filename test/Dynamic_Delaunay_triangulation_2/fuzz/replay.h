// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs a fuzz target without libFuzzer: over given files, and over mutations of them that are the
// same every time.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_FUZZ_REPLAY_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_FUZZ_REPLAY_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace fuzz {

inline std::string content_of(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw std::runtime_error("cannot read " + file.string());
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

// The contents of all files below `place`, in an order that does not depend on the file system.
inline std::vector<std::string> contents_below(const std::filesystem::path& place)
{
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(place)) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(place)) {
      if (entry.is_regular_file()) {
        files.push_back(entry.path());
      }
    }
  } else {
    files.push_back(place);
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> contents;
  for (const std::filesystem::path& file : files) {
    contents.push_back(content_of(file));
  }
  return contents;
}

// Changes seeds at random: bits, bytes, parts that go, come twice, or come from another seed, and
// words at which parsers have been seen to fail.
class Mutator
{
public:
  explicit Mutator(const std::vector<std::string>& seeds)
    : m_seeds(seeds)
  {
  }

  std::string operator()()
  {
    std::string input = any_of(m_seeds);
    for (std::size_t edits = 1 + below(6); edits != 0; --edits) {
      edit(input);
    }
    input.resize(std::min<std::size_t>(input.size(), 1 << 14));
    return input;
  }

private:
  void edit(std::string& input)
  {
    const std::size_t place = below(input.size() + 1);
    switch (below(6)) {
    case 0:
      flip_bit(input);
      break;
    case 1:
      input.insert(place, 1, static_cast<char>(below(256)));
      break;
    case 2:
      input.erase(place, length());
      break;
    case 3:
      input.insert(place, part_of(input));
      break;
    case 4:
      input.insert(place, any_of(m_words));
      break;
    default:
      input.insert(place, part_of(any_of(m_seeds)));
    }
  }

  void flip_bit(std::string& input)
  {
    if (!input.empty()) {
      char& byte = input[below(input.size())];
      byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1u << below(8)));
    }
  }

  std::string part_of(const std::string& text)
  {
    return text.substr(below(text.size() + 1), length());
  }

  // Mostly short.
  std::size_t length() { return below(std::size_t(1) << (1 + below(8))); }

  const std::string& any_of(const std::vector<std::string>& texts)
  {
    return texts[below(texts.size())];
  }

  // Distributions of the standard library differ between its implementations.
  std::size_t below(std::size_t end) { return static_cast<std::size_t>(m_random() % end); }

  const std::vector<std::string>& m_seeds;
  const std::vector<std::string> m_words = {"0",
                                            "-1",
                                            "1e308",
                                            "-1e308",
                                            "1e-320",
                                            "1e999",
                                            "nan",
                                            "inf",
                                            "1000000000",
                                            "9223372036854775807",
                                            "-9223372036854775808",
                                            "18446744073709551616",
                                            std::string(1, '\0'),
                                            "\n",
                                            "[[[["};
  std::mt19937_64 m_random{1};
};

// Keeps an input that is a finding. (One that ends the program is found again with a debugger, the
// inputs being the same every time.)
inline void examine_or_keep(const std::string& input, const std::string& file)
{
  try {
    examine(input);
  } catch (const std::exception& error) {
    std::ofstream(file, std::ios::binary) << input;
    throw std::runtime_error(std::string(error.what()) + "; the input is kept in " + file);
  }
}

inline std::vector<std::string> seeds_in(const std::vector<std::string>& places)
{
  std::vector<std::string> seeds;
  for (const std::string& place : places) {
    const auto more = contents_below(place);
    seeds.insert(seeds.end(), more.begin(), more.end());
  }
  if (seeds.empty()) {
    throw std::runtime_error("there are no files to start from");
  }
  return seeds;
}

inline void examine_all(const std::vector<std::string>& seeds, std::size_t mutations,
                        const std::string& file)
{
  for (const std::string& seed : seeds) {
    examine_or_keep(seed, file);
  }
  Mutator mutated(seeds);
  for (std::size_t i = 0; i != mutations; ++i) {
    examine_or_keep(mutated(), file);
  }
  std::cout << seeds.size() << " files and " << mutations << " mutations without a finding\n";
}

// Arguments: how many mutations, then files and directories of seeds.
inline int replay(int argc, char** argv)
{
  const std::string program = argv[0];
  if (argc < 3) {
    std::cerr << "usage: " << program << " NUMBER_OF_MUTATIONS FILE_OR_DIRECTORY...\n";
    return 2;
  }
  try {
    examine_all(seeds_in({argv + 2, argv + argc}), std::stoul(argv[1]), program + ".finding");
    return 0;
  } catch (const std::exception& error) {
    std::cerr << program << ": " << error.what() << "\n";
    return 1;
  }
}

} // namespace fuzz

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_FUZZ_REPLAY_H
