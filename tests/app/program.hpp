#pragma once

#include <array>
#include <cstdio>
#include <string>

#include <sys/wait.h>

namespace sabo {

/// What the program printed, stdout and stderr together, and its exit code.
struct Outcome {
  int code = -1;
  std::string text;
};

/// Runs a shell command in which "sabo" stands for the program under test.
inline Outcome run_shell(const std::string& command) {
  const std::string line = "sabo() { \"" SABO_PROGRAM "\" \"$@\"; }; { " + command + "; } 2>&1";
  Outcome outcome;
  std::FILE* pipe = popen(line.c_str(), "r");
  if (!pipe) return outcome;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
    outcome.text.append(buffer.data(), count);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) outcome.code = WEXITSTATUS(status);
  return outcome;
}

}  // namespace sabo
