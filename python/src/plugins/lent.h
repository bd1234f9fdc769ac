// What C++ lends to a script during a call.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>

#include "made.h"

namespace elsie::python {

/// Something of the simulator that is valid during a call only. Objects of Python share it, and
/// live as long as the script likes.
template <class T>
struct Lent : Made {
  T* at = nullptr;
  std::uint64_t call = 0;  // counts the calls

  bool is_valid() const { return at != nullptr; }
  T& operator*() const {
    if (!at) {
      throw std::runtime_error(
          "what `now` gives is valid during the call only; keep numbers or copies instead");
    }
    return *at;
  }
  T* operator->() const { return &**this; }
};
template <class T>
using LentTo = std::shared_ptr<Lent<T>>;

/// Lends while it lives.
template <class T>
class Lending {
 public:
  Lending(Lent<T>& to, T& what) : to_(to), before_(to.at) {
    to.at = &what;
    ++to.call;
  }
  ~Lending() { to_.at = before_; }
  Lending(const Lending&) = delete;
  Lending& operator=(const Lending&) = delete;

 private:
  Lent<T>& to_;
  T* before_;
};

}  // namespace elsie::python
