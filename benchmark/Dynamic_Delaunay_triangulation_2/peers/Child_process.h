// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_CHILD_PROCESS_H
#define PEERS_CHILD_PROCESS_H

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

extern char** environ;

namespace peers {

// A program that is talked to through its standard input and output. It has to end when its input
// does.
class Child_process
{
public:
  // `command` is a program, searched as a shell does, and its arguments.
  explicit Child_process(std::vector<std::string> command)
    : m_name(command.front())
  {
    signal(SIGPIPE, SIG_IGN); // if it has ended, writing shall fail and not kill
    open_pipe(m_input);
    open_pipe(m_output);
    spawn(command);
    close_end(m_input[0]);
    close_end(m_output[1]);
  }
  Child_process(const Child_process&) = delete;
  Child_process& operator=(const Child_process&) = delete;

  ~Child_process()
  {
    for (int* const end : {&m_input[0], &m_input[1], &m_output[0], &m_output[1]}) {
      close_end(*end);
    }
    while (waitpid(m_id, nullptr, 0) == -1 && errno == EINTR) {
    }
  }

  void write(const void* bytes, std::size_t size)
  {
    transfer(size, [&](std::size_t done) {
      return ::write(m_input[1], static_cast<const char*>(bytes) + done, size - done);
    });
  }

  void read(void* bytes, std::size_t size)
  {
    transfer(size, [&](std::size_t done) {
      return ::read(m_output[0], static_cast<char*>(bytes) + done, size - done);
    });
  }

  std::string read_line()
  {
    std::string line;
    for (char c = 0; read(&c, 1), c != '\n';) {
      line += c;
    }
    return line;
  }

private:
  using Pipe = std::array<int, 2>; // its end for reading, its end for writing

  static void open_pipe(Pipe& ends)
  {
    if (pipe(ends.data()) != 0) {
      throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
    }
    for (const int end : ends) {
      fcntl(end, F_SETFD, FD_CLOEXEC);
    }
  }

  static void close_end(int& end)
  {
    if (end != -1) {
      close(end);
    }
    end = -1;
  }

  void spawn(std::vector<std::string>& command)
  {
    std::vector<char*> arguments;
    for (std::string& argument : command) {
      arguments.push_back(argument.data());
    }
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, m_input[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, m_output[1], STDOUT_FILENO);
    const int error =
        posix_spawnp(&m_id, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
      throw std::runtime_error(m_name + " cannot be started: " + std::strerror(error));
    }
  }

  template <class Step>
  void transfer(std::size_t size, const Step& step)
  {
    for (std::size_t done = 0; done != size;) {
      const ssize_t bytes = step(done);
      if (bytes > 0) {
        done += static_cast<std::size_t>(bytes);
      } else if (bytes == 0 || errno != EINTR) {
        throw std::runtime_error(m_name + " has ended");
      }
    }
  }

  std::string m_name;
  pid_t m_id = 0;
  Pipe m_input{-1, -1};
  Pipe m_output{-1, -1};
};

} // namespace peers

#endif // PEERS_CHILD_PROCESS_H
