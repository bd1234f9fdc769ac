# elsie_add_plugin(NAME source...)
#
# Builds one plugin library with the flags that plugins need, into the directory where the program looks for them:
# - hidden visibility: two plugins with a helper class of the same name must not run each other's code;
# - -Wl,--as-needed: a plugin loads the storeys that it uses, and no others;
# - -Wl,--no-undefined: a missing symbol is found when the plugin is linked, not when it is loaded;
# - -fno-gnu-unique: an inline static in a template would keep the library loaded for ever;
# - -O2 -g1, unless the user sets a build type or such flags: fast, and crash reports name lines;
# - in projects outside of Elsie, warnings about methods that almost override one of a base class.
function(elsie_add_plugin name)
  if(NOT ARGN)
    message(FATAL_ERROR "elsie_add_plugin(${name}) names no source; write elsie_add_plugin(${name} ${name}.cpp)")
  endif()
  if(NOT TARGET elsie::elsie)
    message(FATAL_ERROR "elsie_add_plugin(${name} ...) needs the core; write find_package(elsie REQUIRED COMPONENTS core)")
  endif()
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE elsie::elsie $<TARGET_NAME_IF_EXISTS:elsie::inference>)
  target_link_options(${name} PRIVATE -Wl,--as-needed)
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
  # Bit-identical runs: no fused multiply-add, which compilers use differently.
  target_compile_options(${name} PRIVATE -ffp-contract=off)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${name} PRIVATE -fno-gnu-unique)
  endif()
  get_property(is_multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
  if(NOT CMAKE_BUILD_TYPE AND NOT is_multi_config)
    if(NOT CMAKE_CXX_FLAGS MATCHES "(^| )-O")
      target_compile_options(${name} PRIVATE -O2)
    endif()
    if(NOT CMAKE_CXX_FLAGS MATCHES "(^| )-g")
      target_compile_options(${name} PRIVATE -g1)
    endif()
  endif()
  if(ELSIE_PLUGIN_HEADERS)
    target_precompile_headers(${name} REUSE_FROM ${ELSIE_PLUGIN_HEADERS})
  endif()
  if(NOT TARGET elsie_compiler)
    target_compile_options(${name} PRIVATE -Woverloaded-virtual $<$<CXX_COMPILER_ID:GNU>:-Wsuggest-override>)
  endif()
  if(NOT ELSIE_SANITIZE)
    target_link_options(${name} PRIVATE -Wl,--no-undefined)
  endif()
endfunction()

# Catch2's main() takes four times as long to compile as a test: once for all tests of a project, if the package of Catch2 2.13 does not have it
# compiled.
function(elsie_catch_main)
  if(NOT TARGET Catch2::Catch2WithMain)
    set(source "${CMAKE_CURRENT_BINARY_DIR}/catch_main.cpp")
    file(CONFIGURE OUTPUT "${source}" CONTENT "#define CATCH_CONFIG_MAIN\n#include <catch2/catch.hpp>\n")
    add_library(elsie_catch_main STATIC "${source}")
    target_link_libraries(elsie_catch_main PUBLIC Catch2::Catch2)
    add_library(Catch2::Catch2WithMain ALIAS elsie_catch_main)
  endif()
endfunction()

# Refuses a name that a test of this folder has already.
function(elsie_check_test_name name)
  if(TEST "${name}")
    message(FATAL_ERROR "there is a test '${name}' already; give one of the two another name: elsie_add_plugin_test(NAME ...) or "
                        "elsie_add_world_test(WORLD.xml NAME ...)")
  endif()
endfunction()

# elsie_add_plugin_test(NAME source... [PLUGINS plugin...])
#
# A test program test_NAME with the test library, and with Catch2 if it was found (find_package() comes first), as a test of this name. It finds the
# plugins that are named, or else those built into the same folder, before installed ones; and it runs in the source
# folder, so that it finds worlds and golden traces by their names.
function(elsie_add_plugin_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "PLUGINS")
  if(NOT TARGET elsie::testing)
    message(FATAL_ERROR "elsie_add_plugin_test(${name} ...) needs the test library; write find_package(elsie REQUIRED COMPONENTS testing)")
  endif()
  elsie_check_test_name(${name})
  add_executable(test_${name} ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(test_${name} PRIVATE elsie::testing)
  if(TARGET Catch2::Catch2)
    elsie_catch_main()
    target_link_libraries(test_${name} PRIVATE Catch2::Catch2WithMain)
  endif()
  if(TARGET elsie_compiler)
    target_link_libraries(test_${name} PRIVATE elsie_compiler)
  endif()
  add_test(NAME ${name} COMMAND test_${name} WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
  set(folders "${CMAKE_CURRENT_BINARY_DIR}")
  if(arg_PLUGINS)
    add_dependencies(test_${name} ${arg_PLUGINS})
    list(TRANSFORM arg_PLUGINS REPLACE "(.+)" "$<TARGET_FILE_DIR:\\1>" OUTPUT_VARIABLE folders)
  endif()
  list(TRANSFORM folders PREPEND "ELSIE_PLUGIN_PATH=path_list_prepend:")
  # The same bits on every x86-64 processor, as in bin/elsie.
  list(APPEND folders "GLIBC_TUNABLES=set:glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4")
  set_tests_properties(${name} PROPERTIES ENVIRONMENT_MODIFICATION "${folders}")
endfunction()

# elsie_add_world_test(WORLD.xml [NAME name])
#
# Adds a test that runs a world of this folder with the plugins built here; it must reach its goals. Without NAME the test is called like the file,
# with the folder in it: a/world for a/world.xml.
function(elsie_add_world_test world)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "NAME" "")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "elsie_add_world_test(${world} ${arg_UNPARSED_ARGUMENTS}): expected one world, and perhaps NAME and a name")
  endif()
  if(NOT EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${world}")
    message(FATAL_ERROR "elsie_add_world_test(${world}): there is no such file in ${CMAKE_CURRENT_SOURCE_DIR}")
  endif()
  if(NOT arg_NAME)
    string(REGEX REPLACE "\\.xml$" "" arg_NAME "${world}")
  endif()
  elsie_check_test_name("${arg_NAME}")
  add_test(NAME "${arg_NAME}" COMMAND "${ELSIE_PROGRAM}" run "${CMAKE_CURRENT_SOURCE_DIR}/${world}" --plugin-path
                                      "${CMAKE_CURRENT_BINARY_DIR}" --quiet)
endfunction()
