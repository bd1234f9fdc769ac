// The ABI word: everything that must be the same on both sides before a plugin and its host may
// exchange a C++ object.
//
// It is text of the form "key=value;key=value;...", so that a refusal can name the flag that
// differs. Each plugin library carries it in an ELF note, which the host reads from the file before
// it loads the library.
#pragma once

#include <version>  // the macros of the standard library

/// The version of the plugin interface. A host loads plugins of its own major version whose minor
/// version is not above its own. Before 1.0, any change that breaks a plugin raises the minor
/// version and older plugins are refused too.
#define ELSIE_API_MAJOR 0
#define ELSIE_API_MINOR 10

#define ELSIE_ABI_TEXT_(x) #x
#define ELSIE_ABI_TEXT(x) ELSIE_ABI_TEXT_(x)

#define ELSIE_ABI_API "api=" ELSIE_ABI_TEXT(ELSIE_API_MAJOR) "." ELSIE_ABI_TEXT(ELSIE_API_MINOR)

#if defined(_LIBCPP_VERSION)
#define ELSIE_ABI_RUNTIME ";runtime=libc++"
#elif defined(__GLIBCXX__) && _GLIBCXX_USE_CXX11_ABI
#define ELSIE_ABI_RUNTIME ";runtime=libstdc++-cxx11"
#elif defined(__GLIBCXX__)
#define ELSIE_ABI_RUNTIME ";runtime=libstdc++-cxx98"
#else
#define ELSIE_ABI_RUNTIME ";runtime=unknown"
#endif

#if defined(_GLIBCXX_DEBUG)
#define ELSIE_ABI_CONTAINERS ";containers=debug"
#else
#define ELSIE_ABI_CONTAINERS ";containers=plain"
#endif

#if defined(__SANITIZE_ADDRESS__)
#define ELSIE_ABI_SANITIZER ";sanitizer=address"
#elif defined(__SANITIZE_THREAD__)
#define ELSIE_ABI_SANITIZER ";sanitizer=thread"
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define ELSIE_ABI_SANITIZER ";sanitizer=address"
#else
#define ELSIE_ABI_SANITIZER ";sanitizer=none"
#endif
#else
#define ELSIE_ABI_SANITIZER ";sanitizer=none"
#endif

#define ELSIE_ABI_POINTER ";pointer=" ELSIE_ABI_TEXT(__SIZEOF_POINTER__)

/// The ABI word of this translation unit.
#define ELSIE_ABI_WORD \
  ELSIE_ABI_API ELSIE_ABI_RUNTIME ELSIE_ABI_CONTAINERS ELSIE_ABI_SANITIZER ELSIE_ABI_POINTER

/// Owner and type of the ELF note that carries the word.
#define ELSIE_ABI_NOTE_OWNER "elsie"
#define ELSIE_ABI_NOTE_TYPE 1

/// Places an ELF note with the given word (a literal) into the library, for registration.h. Layout
/// after the System V ABI: sizes of owner and text, type, then both, padded to four bytes.
#define ELSIE_EMIT_ABI_NOTE_(word) \
  asm(".pushsection .note.elsie, \"a\", %note\n"                       \
      ".balign 4\n"                                                   \
      ".long 2f - 1f\n"                                               \
      ".long 4f - 3f\n"                                               \
      ".long " ELSIE_ABI_TEXT(ELSIE_ABI_NOTE_TYPE) "\n"               \
      "1: .asciz \"" ELSIE_ABI_NOTE_OWNER "\"\n"                      \
      "2: .balign 4\n"                                                \
      "3: .asciz \"" word "\"\n"                                      \
      "4: .balign 4\n"                                                \
      ".popsection")
