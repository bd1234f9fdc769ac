# elsie_add_plugin(NAME source...)
#
# Builds one plugin library with the flags that plugins need, into the directory where the program looks for them:
# - hidden visibility: two plugins with a helper class of the same name must not run each other's code;
# - -Wl,--no-undefined: a missing symbol is found when the plugin is linked, not when it is loaded;
# - -fno-gnu-unique: an inline static in a template would keep the library loaded for ever.
function(elsie_add_plugin name)
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE elsie::elsie)
  if(TARGET elsie_compiler)
    target_link_libraries(${name} PRIVATE elsie_compiler)
  endif()
  set_target_properties(
    ${name}
    PROPERTIES PREFIX ""
               CXX_VISIBILITY_PRESET hidden
               VISIBILITY_INLINES_HIDDEN ON
               INSTALL_RPATH "$ORIGIN/../..")
  if(ELSIE_PLUGIN_OUTPUT_DIRECTORY)
    set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY "${ELSIE_PLUGIN_OUTPUT_DIRECTORY}")
  endif()
  # Bit-identical runs: no fused multiply-add that one compiler makes and another does not.
  target_compile_options(${name} PRIVATE -ffp-contract=off)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${name} PRIVATE -fno-gnu-unique)
  endif()
  if(NOT ELSIE_SANITIZE)
    target_link_options(${name} PRIVATE -Wl,--no-undefined)
  endif()
endfunction()

# elsie_add_world_test(WORLD.xml)
#
# A test that runs a world of this folder with the plugins that are built here: it must reach its goals.
function(elsie_add_world_test world)
  get_filename_component(name "${world}" NAME_WE)
  add_test(NAME ${name} COMMAND "${ELSIE_PROGRAM}" run "${CMAKE_CURRENT_SOURCE_DIR}/${world}" --plugin-path
                                "${CMAKE_CURRENT_BINARY_DIR}" --quiet)
endfunction()
