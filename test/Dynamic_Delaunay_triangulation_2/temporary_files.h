// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files that tests write for programs to read.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_TEMPORARY_FILES_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_TEMPORARY_FILES_H

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <system_error>

// Of this process alone, and gone when it ends.
class Temporary_directory
{
public:
  Temporary_directory()
    : m_path(testing::TempDir() + "dynamic_delaunay_" + std::to_string(std::random_device()()))
  {
    std::filesystem::create_directories(m_path);
  }
  Temporary_directory(const Temporary_directory&) = delete;
  Temporary_directory& operator=(const Temporary_directory&) = delete;
  ~Temporary_directory()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }

  std::string path(const std::string& name) const { return (m_path / name).string(); }

private:
  std::filesystem::path m_path;
};

inline std::string temporary_path(const std::string& name)
{
  static const Temporary_directory directory;
  return directory.path(name);
}

inline std::string write_file(const std::string& name, const std::string& content)
{
  const std::string path = temporary_path(name);
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

inline std::string content_of(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_TEMPORARY_FILES_H
