# One interface target carries every compile option of the project.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_package(OpenMP REQUIRED COMPONENTS CXX)
find_program(SABO_CCACHE ccache)
if(SABO_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${SABO_CCACHE})
endif()

add_library(sabo_options INTERFACE)
# nvcc is given its own options in SaboCuda.cmake.
function(sabo_cxx_options)
  target_compile_options(sabo_options INTERFACE "$<$<COMPILE_LANGUAGE:CXX>:${ARGN}>")
endfunction()
sabo_cxx_options(-Wall -Wextra -Wpedantic -Wshadow)
if(SABO_WARNINGS_AS_ERRORS)
  sabo_cxx_options(-Werror)
endif()
# Nobody reads errno or floating-point traps; without these two, loops with sqrt stay scalar.
sabo_cxx_options(-fno-math-errno -fno-trapping-math)
if(SABO_SANITIZE)
  sabo_cxx_options(-fsanitize=${SABO_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(sabo_options INTERFACE -fsanitize=${SABO_SANITIZE})
endif()

# For builds by clang, where it halves the time of a small file: GCC takes longer with such headers.
# The release build goes without, so each file still names what it includes.
option(SABO_PRECOMPILE "Compile the headers that most files include once for each target" OFF)
function(sabo_precompile target)
  if(SABO_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE <algorithm> <cmath> <filesystem> <functional> <map>
      <memory> <optional> <string> <variant> <vector> ${ARGN})
  endif()
endfunction()
