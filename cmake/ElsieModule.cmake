# elsie_module(NAME SOURCES file... [ALONE file...] [USES module...] [LIBRARIES target...])
#
# Adds a module. Its public headers are in include/elsie/NAME/. It sees the headers of the modules under USES, and of theirs, and no
# others, which separates the layers of docs/internals/architecture.md: these modules must have been added before. Sources under ALONE are in no batch
# (ELSIE_UNITY).
function(elsie_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;ALONE;USES;LIBRARIES")
  add_library(elsie_module_${name} OBJECT ${arg_SOURCES} ${arg_ALONE})
  set_source_files_properties(${arg_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_include_directories(
    elsie_module_${name}
    PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}/include"
    PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/src")
  target_compile_definitions(elsie_module_${name} PRIVATE ELSIE_BUILDING_CORE)
  target_link_libraries(elsie_module_${name} PRIVATE elsie_compiler ${arg_LIBRARIES})
  # Most files include most of these; compiled once, they cost a module a third less. `make lint` compiles every file without them.
  if(name STREQUAL "base")
    target_precompile_headers(
      elsie_module_base
      PRIVATE
      <algorithm>
      <array>
      <cmath>
      <cstdint>
      <filesystem>
      <functional>
      <map>
      <memory>
      <optional>
      <span>
      <sstream>
      <string>
      <string_view>
      <utility>
      <variant>
      <vector>)
  else()
    target_precompile_headers(elsie_module_${name} REUSE_FROM elsie_module_base)
  endif()
  foreach(used IN LISTS arg_USES)
    if(NOT TARGET elsie_module_${used})
      message(FATAL_ERROR "The module '${name}' uses '${used}', which is no module of a lower storey, nor one that comes before it in its own "
                          "storey: nothing looks upwards (docs/internals/architecture.md, \"Storeys\").")
    endif()
    target_include_directories(elsie_module_${name}
                               PUBLIC $<TARGET_PROPERTY:elsie_module_${used},INTERFACE_INCLUDE_DIRECTORIES>)
  endforeach()
  set_target_properties(elsie_module_${name} PROPERTIES ELSIE_FOLDER "${CMAKE_CURRENT_SOURCE_DIR}" ELSIE_LIBRARIES "${arg_LIBRARIES}"
                                                         ELSIE_USES "${arg_USES}")
endfunction()

# elsie_text(MODULE NAME FILE): compiles a file in, as `extern const char* const NAME` of the namespace elsie::MODULE. The module's source is
# "${CMAKE_CURRENT_BINARY_DIR}/NAME.cpp".
function(elsie_text module name file)
  file(READ "${file}" text)
  file(CONFIGURE OUTPUT ${name}.cpp CONTENT [=[
namespace elsie::@module@ {
extern const char* const @name@;
const char* const @name@ = R"text(@text@)text";
}  // namespace elsie::@module@
]=] @ONLY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
endfunction()

# elsie_library(NAME FILE file-name MODULES module... [USES library...] [COMPONENT component])
#
# Adds a storey of docs/internals/architecture.md: a shared library of some modules, elsie::NAME, component NAME of the package, that links to
# the storeys under USES and to what its modules need, and to nothing else: the linker refuses symbols of other storeys, and CMake modules that use headers of other storeys.
function(elsie_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "FILE;COMPONENT" "MODULES;USES")
  if(NOT arg_COMPONENT)
    set(arg_COMPONENT ${name})
  endif()
  add_library(elsie_${name} SHARED)
  add_library(elsie::${name} ALIAS elsie_${name})
  set_target_properties(elsie_${name} PROPERTIES OUTPUT_NAME ${arg_FILE} EXPORT_NAME ${name} VERSION ${PROJECT_VERSION} SOVERSION 0
                                                 INSTALL_RPATH "$ORIGIN" ELSIE_COMPONENT ${arg_COMPONENT})
  # The modules that this storey may see: its own, and those of the storeys that it links to, directly or not.
  set(seen ${arg_MODULES})
  foreach(used IN LISTS arg_USES)
    get_target_property(below elsie_${used} ELSIE_MODULES)
    list(APPEND seen ${below})
  endforeach()
  set_target_properties(elsie_${name} PROPERTIES ELSIE_MODULES "${seen}")
  foreach(module IN LISTS arg_MODULES)
    get_target_property(uses elsie_module_${module} ELSIE_USES)
    list(REMOVE_ITEM uses ${seen})
    if(uses)
      message(FATAL_ERROR "The module '${module}' of the storey '${name}' uses ${uses}, which is not in this storey or in one that it links to "
                          "(docs/internals/architecture.md, \"Storeys\"). Add the storey under USES of elsie_library(${name} ...) if it is below.")
    endif()
    get_target_property(folder elsie_module_${module} ELSIE_FOLDER)
    get_target_property(libraries elsie_module_${module} ELSIE_LIBRARIES)
    target_sources(elsie_${name} PRIVATE $<TARGET_OBJECTS:elsie_module_${module}>)
    target_include_directories(elsie_${name} INTERFACE "$<BUILD_INTERFACE:${folder}/include>")
    install(DIRECTORY "${folder}/include/" TYPE INCLUDE)
    if(libraries)
      target_link_libraries(elsie_${name} PRIVATE ${libraries})
    endif()
    # The headers have the same place as when installed, so that plugins can be compiled against the build folder, too.
    file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/include/elsie")
    file(CREATE_LINK "${folder}/include/elsie/${module}" "${CMAKE_BINARY_DIR}/include/elsie/${module}" SYMBOLIC)
  endforeach()
  target_include_directories(elsie_${name} INTERFACE "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  target_compile_features(elsie_${name} INTERFACE cxx_std_20)
  list(TRANSFORM arg_USES PREPEND elsie::)
  target_link_libraries(elsie_${name} PUBLIC ${arg_USES} PRIVATE elsie_compiler Threads::Threads ${CMAKE_DL_LIBS})
  # Calls inside a library need no look-up when the program starts.
  target_link_options(elsie_${name} PRIVATE -Wl,--as-needed -Wl,-Bsymbolic-functions)
  if(NOT ELSIE_SANITIZE)
    target_link_options(elsie_${name} PRIVATE -Wl,--no-undefined)
  endif()
  set_property(GLOBAL APPEND PROPERTY ELSIE_STOREYS elsie_${name})
endfunction()
