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
#define ELSIE_API_MINOR 15

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

// The values name the flag to leave out: a refusal shows them.
#if defined(__cpp_rtti)
#define ELSIE_ABI_RTTI ";rtti=on"
#else
#define ELSIE_ABI_RTTI ";rtti=off by -fno-rtti"
#endif

#if defined(__cpp_exceptions)
#define ELSIE_ABI_EXCEPTIONS ";exceptions=on"
#else
#define ELSIE_ABI_EXCEPTIONS ";exceptions=off by -fno-exceptions"
#endif

#if __SIZEOF_WCHAR_T__ == 4
#define ELSIE_ABI_WCHAR ";wchar_t=4"
#else
#define ELSIE_ABI_WCHAR ";wchar_t=2 by -fshort-wchar"
#endif

// On x86-64, -mlong-double-64 and -mlong-double-128 change it, and the names of functions with it.
#define ELSIE_ABI_LONG_DOUBLE ";long_double_bits=" ELSIE_ABI_TEXT(__LDBL_MANT_DIG__)

#define ELSIE_ABI_POINTER ";pointer=" ELSIE_ABI_TEXT(__SIZEOF_POINTER__)

// What no macro tells is refused by the compiler.
namespace elsie::detail {
struct Unpacked {
  char first;
  double second;
};
enum Enumeration { kItsOnlyValue };
static_assert(sizeof(Unpacked) == 2 * sizeof(double),
              "this plugin is compiled with -fpack-struct, or after #pragma pack, so that its "
              "objects do not fit Elsie's: leave that out");
static_assert(sizeof(Enumeration) == sizeof(int),
              "this plugin is compiled with -fshort-enums, so that its objects do not fit Elsie's: "
              "leave that out");
#if defined(__x86_64__)
static_assert(__is_same(void(), void __attribute__((sysv_abi)) ()),
              "this plugin is compiled with -mabi=ms, so that it calls functions otherwise than "
              "Elsie: leave that out");
#endif
}  // namespace elsie::detail

/// The ABI word of this translation unit.
#define ELSIE_ABI_WORD                                                                       \
  ELSIE_ABI_API ELSIE_ABI_RUNTIME ELSIE_ABI_CONTAINERS ELSIE_ABI_SANITIZER ELSIE_ABI_POINTER \
      ELSIE_ABI_RTTI ELSIE_ABI_EXCEPTIONS ELSIE_ABI_WCHAR ELSIE_ABI_LONG_DOUBLE

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
