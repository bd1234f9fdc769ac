# Compiler settings of all targets of the project.
add_library(elsie_compiler INTERFACE)
target_compile_features(elsie_compiler INTERFACE cxx_std_20)
target_compile_options(
  elsie_compiler
  INTERFACE -Wall
            -Wextra
            -Wpedantic
            -Wshadow
            -Wconversion
            -Wnon-virtual-dtor
            -Wold-style-cast
            -Woverloaded-virtual
            # GCC 12 sees overlaps and overruns in "text" + std::string that are none (GCC bug 105651).
            "$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-array-bounds>"
            # GCC takes a source of a batch for a header, whose classes should have no members of unnamed namespaces.
            "$<$<AND:$<BOOL:${ELSIE_UNITY}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>"
            # Not a part of GCC's -Wconversion.
            "$<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>"
            # Bit-identical runs: no fused multiply-add that one compiler makes and another does not.
            -ffp-contract=off)
if(ELSIE_SANITIZE STREQUAL "thread")
  target_compile_options(elsie_compiler INTERFACE -O1 -g1 -fsanitize=thread -fno-omit-frame-pointer
    # Boost.Asio has fences, which the thread sanitizer does not follow; what they guard is behind its mutexes too.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-tsan>)
  target_link_options(elsie_compiler INTERFACE -fsanitize=thread)
elseif(ELSIE_SANITIZE)
  # The programs of tests are not looked at themselves: what they test is. They compile with the options of any other build, so that ccache
  # has them already.
  set(tested $<NOT:$<BOOL:$<TARGET_PROPERTY:ELSIE_TEST_PROGRAM>>>)
  target_compile_options(elsie_compiler INTERFACE
    $<${tested}:-O1;-g1;-fsanitize=address,undefined;-fno-omit-frame-pointer;-fno-sanitize-recover=undefined>
    # With the sanitizers, GCC 12 does not see that a std::variant is initialised.
    $<$<AND:${tested},$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)
  target_link_options(elsie_compiler INTERFACE -fsanitize=address,undefined)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    # Coverage for the fuzz targets (tests/fuzz). Plugins' classes are hidden, so that their types seem to differ when they are
    # called through pointers.
    target_compile_options(elsie_compiler INTERFACE -fsanitize=fuzzer-no-link -fno-sanitize=function,vptr)
  endif()
endif()
