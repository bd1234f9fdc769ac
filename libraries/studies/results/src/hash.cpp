#include "elsie/results/hash.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include <openssl/evp.h>

namespace elsie::results {

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned int size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("OpenSSL's libcrypto has no SHA-256 here");
  }
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < size; ++i) {
    text += kDigits[digest[i] >> 4U];
    text += kDigits[digest[i] & 15U];
  }
  return text;
}

std::string file_content(const std::string& path) {
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  const int refusal = errno;
  // Reads in large pieces, because libraries with debug information are large.
  std::string content;
  std::string piece(1U << 20U, '\0');
  while (in.read(piece.data(), static_cast<std::streamsize>(piece.size())), in.gcount() > 0) {
    content.append(piece, 0, static_cast<std::size_t>(in.gcount()));
  }
  if (!in.eof()) {
    const int error = in.is_open() ? errno : refusal;
    throw std::runtime_error("'" + path +
                             "' cannot be read: " + std::generic_category().message(error) +
                             (error == EMFILE ? "; let the program have more (ulimit -n)" : ""));
  }
  return content;
}

}  // namespace elsie::results
