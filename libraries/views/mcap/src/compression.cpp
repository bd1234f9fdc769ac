#include "compression.h"

#include <algorithm>
#include <stdexcept>

namespace elsie::mcap {

Compressor::Compressor(int level) : context_(ZSTD_createCCtx()) {
  if (!context_ ||
      ZSTD_isError(ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_compressionLevel, level))) {
    throw std::runtime_error("zstd cannot be set up");
  }
}

std::string Compressor::operator()(std::string_view bytes) {
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress2(context_.get(), out.data(), out.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(size)) {
    throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(size));
  }
  out.resize(size);
  return out;
}

std::string decompressed(std::string_view bytes, std::uint64_t size, std::string& problem) {
  struct Free {
    void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
  };
  const std::unique_ptr<ZSTD_DCtx, Free> context(ZSTD_createDCtx());
  std::string out;
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  std::size_t left = 1;  // of the frame
  while (problem.empty() && left != 0) {
    // A step at a time, and one byte more than allowed: a wrong size is found, not believed.
    constexpr std::uint64_t kStep = 1U << 18U;
    const std::size_t before = out.size();
    out.resize(before + static_cast<std::size_t>(std::min(kStep, size - before) + 1));
    ZSTD_outBuffer to{out.data(), out.size(), before};
    left = ZSTD_decompressStream(context.get(), &to, &in);
    const bool stuck = to.pos == before && in.pos == in.size;
    out.resize(to.pos);
    if (ZSTD_isError(left)) {
      problem = ZSTD_getErrorName(left);
    } else if (out.size() > size) {
      problem = "more bytes come out than it says";
    } else if (left != 0 && stuck) {
      problem = "it breaks off";
    }
  }
  if (problem.empty() && (out.size() != size || in.pos != in.size)) {
    problem = "fewer bytes come out than it says";
  }
  return out;
}

}  // namespace elsie::mcap
