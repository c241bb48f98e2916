// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A test that several ranks run, chosen by its name. All themes are in one program, since compiling
// the triangulations that they share takes most of the time.

#ifndef DISTRIBUTED_THEME_H
#define DISTRIBUTED_THEME_H

#include <map>
#include <string>
#include <vector>

inline std::map<std::string, void (*)()>& themes()
{
  static std::map<std::string, void (*)()> all;
  return all;
}

struct Theme
{
  Theme(const char* name, void (*run)()) { themes().emplace(name, run); }
};

inline std::vector<std::string> theme_arguments; // of the program, after the theme's name

#endif // DISTRIBUTED_THEME_H
