#include <cstdlib>

// A thread that waits for the others at the end of a loop should soon go to sleep: on a machine
// that does something else as well, spinning takes the core away from the very thread it waits for.
// With two busy programs beside it on two cores the example ran tens of times slower with the
// default spinning, three times slower with this; on an idle machine it makes no difference. The
// OpenMP library reads its environment before main() and before any constructor of the program,
// hence the array of functions that run before those of libraries.
namespace {

void shorten_spinning() { setenv("GOMP_SPINCOUNT", "1000", 0); }

[[gnu::section(".preinit_array"), gnu::used]] void (*const before_libraries)() = shorten_spinning;

}  // namespace
