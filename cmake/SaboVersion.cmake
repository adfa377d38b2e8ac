# Writes base/version.hpp into the build tree. Only the few files that need the version include it,
# so that a new commit recompiles those alone.
#   0.1.0                 a tagged commit (v0.1.0), or no git
#   0.1.0+g1a2b3c4        another commit; "-dirty" follows where files were changed
set(SABO_VERSION ${PROJECT_VERSION})

find_package(Git QUIET)
if(GIT_FOUND AND EXISTS ${PROJECT_SOURCE_DIR}/.git)
  execute_process(
    COMMAND ${GIT_EXECUTABLE} describe --tags --match "v[0-9]*" --always --dirty --abbrev=7
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    OUTPUT_VARIABLE described RESULT_VARIABLE failed
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT failed)
    if(described MATCHES "^v${PROJECT_VERSION}(-dirty)?$")
      set(SABO_VERSION ${PROJECT_VERSION}${CMAKE_MATCH_1})
    elseif(described MATCHES "([0-9a-f]+(-dirty)?)$")
      set(SABO_VERSION ${PROJECT_VERSION}+g${CMAKE_MATCH_1})
    endif()
  endif()
  # A commit or checkout adds a line to this file: configure again.
  execute_process(
    COMMAND ${GIT_EXECUTABLE} rev-parse --git-path logs/HEAD
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    OUTPUT_VARIABLE head_log RESULT_VARIABLE failed
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  get_filename_component(head_log "${head_log}" ABSOLUTE BASE_DIR ${PROJECT_SOURCE_DIR})
  if(NOT failed AND EXISTS ${head_log})
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${head_log})
  endif()
endif()

configure_file(${CMAKE_CURRENT_LIST_DIR}/version.hpp.in
  ${PROJECT_BINARY_DIR}/generated/base/version.hpp @ONLY)
target_include_directories(sabo_options INTERFACE ${PROJECT_BINARY_DIR}/generated)
