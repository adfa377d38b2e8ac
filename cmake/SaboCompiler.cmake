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
sabo_cxx_options(-Wall -Wextra -Wpedantic)
# In files compiled as one a local name may be that of something in another file.
sabo_cxx_options($<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow>)
if(SABO_WARNINGS_AS_ERRORS)
  sabo_cxx_options(-Werror)
endif()
# Nobody reads errno or floating-point traps; without these two, loops with sqrt stay scalar.
sabo_cxx_options(-fno-math-errno -fno-trapping-math)
if(SABO_SANITIZE)
  sabo_cxx_options(-fsanitize=${SABO_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(sabo_options INTERFACE -fsanitize=${SABO_SANITIZE})
endif()

# Several files of a target are compiled as one: half the time, since most of it goes into headers.
# Tests always are; of the program only what the sanitizers go through, so that in the release build
# each file still names what it includes, and shadows nothing.
option(SABO_UNITY "Compile several files as one: those of tests, with sanitizers those of layers" ON)
function(sabo_unity target)
  if(SABO_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
endfunction()

# For builds by clang, where it halves the time of a small file: GCC takes longer with such headers.
# The release build goes without, so each file still names what it includes.
option(SABO_PRECOMPILE "Compile the headers that most files include once for each target" OFF)
function(sabo_precompile target)
  if(SABO_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE <algorithm> <cmath> <filesystem> <functional> <map>
      <memory> <optional> <string> <variant> <vector> ${ARGN})
  endif()
endfunction()
