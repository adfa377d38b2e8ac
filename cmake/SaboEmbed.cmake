# sabo_embed(TARGET function FILE): compiles a file into a library, as `std::string_view
# function()` of namespace sabo, which a header of the library declares.
function(sabo_embed target function file)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded/${function}.cpp)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/embedded.cpp.in ${source} @ONLY)
  # Not compiled as one with other files: each has a label of the same name.
  set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS ${file} SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${target} PRIVATE ${source})
endfunction()
