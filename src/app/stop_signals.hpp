#pragma once

#include <atomic>

namespace sabo {

/// From now on SIGINT (Ctrl-C) and SIGTERM set the flag that is returned; a second SIGINT ends the
/// program at once with exit code 130.
const std::atomic<bool>& catch_stop_signals();

}  // namespace sabo
