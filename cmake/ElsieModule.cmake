# elsie_module(NAME SOURCES file... [USES module...] [LIBRARIES target...])
#
# One module of core/. Its public headers lie in include/elsie/NAME/. It sees the headers of the modules that it names
# under USES, and of theirs, and no others: this is what keeps the layers of docs/architecture.md apart.
function(elsie_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;USES;LIBRARIES")
  add_library(elsie_${name} OBJECT ${arg_SOURCES})
  target_include_directories(
    elsie_${name}
    PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}/include"
    PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/src")
  target_compile_definitions(elsie_${name} PRIVATE ELSIE_BUILDING_CORE)
  target_link_libraries(elsie_${name} PRIVATE elsie_compiler ${arg_LIBRARIES})
  foreach(used IN LISTS arg_USES)
    target_include_directories(elsie_${name}
                               PUBLIC $<TARGET_PROPERTY:elsie_${used},INTERFACE_INCLUDE_DIRECTORIES>)
  endforeach()
  set_property(GLOBAL APPEND PROPERTY ELSIE_MODULES ${name})
  foreach(library IN LISTS arg_LIBRARIES)
    set_property(GLOBAL APPEND PROPERTY ELSIE_LIBRARIES ${library})
  endforeach()
endfunction()
