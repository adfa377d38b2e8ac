#include "app/open_browser.hpp"

#include <array>
#include <cstdlib>
#include <thread>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace sabo {

void open_browser(const std::string& address) {
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY")) return;
  std::string program = "xdg-open", argument = address;
  std::array<char*, 3> arguments{program.data(), argument.data(), nullptr};
  pid_t child = 0;
  if (posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments.data(), environ) != 0)
    return;
  // Some hand over to a browser and end, others last as long as the browser, which has to be
  // served.
  std::thread([child] { waitpid(child, nullptr, 0); }).detach();
}

}  // namespace sabo
