# Compiler settings that every target of the project shares.
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
            -Werror
            # GCC 12 sees overlaps and overruns in "text" + std::string that are none (GCC bug 105651).
            "$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow;-Wno-array-bounds>"
            # Bit-identical runs: no fused multiply-add that one compiler makes and another does not.
            -ffp-contract=off)
if(ELSIE_SANITIZE)
  target_compile_options(elsie_compiler INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer
                                                  -fno-sanitize-recover=undefined)
  # With the sanitizers' code in between, GCC 12 no longer sees that a std::variant is initialised.
  target_compile_options(elsie_compiler INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(elsie_compiler INTERFACE -fsanitize=address,undefined)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    # For the fuzz targets (tests/fuzz): which code an input reaches. Plugins' classes are hidden, so that their types seem to differ when they are
    # called through pointers; and GCC's warnings are those that are errors here.
    target_compile_options(elsie_compiler INTERFACE -fsanitize=fuzzer-no-link -fno-sanitize=function,vptr -Wno-error)
  endif()
endif()
