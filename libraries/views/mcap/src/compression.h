// Compression with zstd.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include <zstd.h>

namespace elsie::mcap {

class Compressor {
 public:
  explicit Compressor(int level);
  /// Throws std::runtime_error when there is no memory for it.
  std::string operator()(std::string_view bytes);

 private:
  struct Free {
    void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
  };
  std::unique_ptr<ZSTD_CCtx, Free> context_;
};

/// The text that was compressed to these bytes; `problem` stays empty if they are sound. `size`:
/// the length that the text must have. Takes no more memory than that, whatever the bytes are.
std::string decompressed(std::string_view bytes, std::uint64_t size, std::string& problem);

}  // namespace elsie::mcap
