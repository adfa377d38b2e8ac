#include "app/stop_signals.hpp"

#include <csignal>
#include <string_view>

#include <unistd.h>

#include "app/exit_code.hpp"

namespace sabo {
namespace {

std::atomic<bool> is_stopping{false};
static_assert(std::atomic<bool>::is_always_lock_free, "only then a signal handler may use it");

void stop(int signal_number) {
  const bool is_again = is_stopping.exchange(true);
  if (is_again && signal_number == SIGINT) _exit(exit_stopped);
  if (is_again) return;
  constexpr std::string_view message =
      "\nStopping; the results so far are written. Ctrl-C again ends at once.\n";
  // Nothing can be done here if the message does not get through.
  [[maybe_unused]] const auto written = write(STDERR_FILENO, message.data(), message.size());
}

}  // namespace

const std::atomic<bool>& catch_stop_signals() {
  struct sigaction action {};
  action.sa_handler = stop;
  action.sa_flags = SA_RESTART;  // a file that is being written is written on
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return is_stopping;
}

}  // namespace sabo
