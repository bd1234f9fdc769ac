#include "elsie/results/hash.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <system_error>

#include <openssl/evp.h>

namespace elsie::results {

namespace {

/// A hash that grows piece by piece.
class Sha256 {
 public:
  Sha256() { expect(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr)); }
  void add(std::string_view bytes) {
    expect(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()));
  }
  std::string digits() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned int size = 0;
    expect(EVP_DigestFinal_ex(context_.get(), digest.data(), &size));
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    for (unsigned int i = 0; i < size; ++i) {
      text += kDigits[digest[i] >> 4U];
      text += kDigits[digest[i] & 15U];
    }
    return text;
  }

 private:
  static void expect(int done) {
    if (done != 1) {
      throw std::runtime_error("OpenSSL's libcrypto has no SHA-256 here");
    }
  }

  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_{EVP_MD_CTX_new(),
                                                                   EVP_MD_CTX_free};
};

/// Gives the bytes of a file, in large pieces: libraries with debug information are large.
template <typename See>
void read_pieces(const std::string& path, const See& see) {
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  const int refusal = errno;
  std::string piece(1U << 18U, '\0');
  while (in.read(piece.data(), static_cast<std::streamsize>(piece.size())), in.gcount() > 0) {
    see(std::string_view(piece).substr(0, static_cast<std::size_t>(in.gcount())));
  }
  if (!in.eof()) {
    const int error = in.is_open() ? errno : refusal;
    throw std::runtime_error("'" + path +
                             "' cannot be read: " + std::generic_category().message(error) +
                             (error == EMFILE ? "; let the program have more (ulimit -n)" : ""));
  }
}

}  // namespace

std::string sha256(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.digits();
}

std::string file_sha256(const std::string& path) {
  Sha256 hash;
  read_pieces(path, [&](std::string_view piece) { hash.add(piece); });
  return hash.digits();
}

std::string file_content(const std::string& path) {
  std::string content;
  read_pieces(path, [&](std::string_view piece) { content += piece; });
  return content;
}

}  // namespace elsie::results
