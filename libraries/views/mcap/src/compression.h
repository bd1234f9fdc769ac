// zstd.
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

/// What was compressed to these bytes; empty text in `problem` when all is well. Takes no more
/// memory than the result does, whatever the bytes are. `size`: what it must come to.
std::string decompressed(std::string_view bytes, std::uint64_t size, std::string& problem);

}  // namespace elsie::mcap
