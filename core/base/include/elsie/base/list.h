// A list whose copies share its items until one of them is changed.
#pragma once

#include <compare>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace elsie::base {

/// Stands for a std::vector<T>. Copying it takes constant time. Access to an item through a list
/// that is not const first copies the item, if another list shares it; so an item with the same
/// address in two lists is the same, and reading should use a const list. A reference to an item
/// must not be used to change it once the list was copied. Several threads may read copies.
template <class T>
class List {
  template <class Owner, class Item>
  class Iterator {
   public:
    using iterator_category = std::random_access_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = Item*;
    using reference = Item&;

    Iterator() = default;
    Iterator(Owner& list, std::size_t at) : list_(&list), at_(static_cast<std::ptrdiff_t>(at)) {}
    Item& operator*() const { return (*list_)[static_cast<std::size_t>(at_)]; }
    Item* operator->() const { return &**this; }
    Item& operator[](std::ptrdiff_t n) const { return *(*this + n); }
    Iterator& operator++() { return *this += 1; }
    Iterator operator++(int) { return std::exchange(*this, *this + 1); }
    Iterator& operator--() { return *this += -1; }
    Iterator operator--(int) { return std::exchange(*this, *this + -1); }
    Iterator& operator+=(std::ptrdiff_t n) {
      at_ += n;
      return *this;
    }
    Iterator& operator-=(std::ptrdiff_t n) { return *this += -n; }
    friend Iterator operator+(Iterator from, std::ptrdiff_t n) { return from += n; }
    friend Iterator operator+(std::ptrdiff_t n, Iterator from) { return from += n; }
    friend Iterator operator-(Iterator from, std::ptrdiff_t n) { return from += -n; }
    friend std::ptrdiff_t operator-(const Iterator& a, const Iterator& b) { return a.at_ - b.at_; }
    friend auto operator<=>(const Iterator&, const Iterator&) = default;

   private:
    Owner* list_ = nullptr;
    std::ptrdiff_t at_ = 0;
  };

 public:
  using value_type = T;
  using iterator = Iterator<List, T>;
  using const_iterator = Iterator<const List, const T>;

  List() = default;
  List(const std::vector<T>& items) {  // NOLINT(google-explicit-constructor)
    for (const T& item : items) push_back(item);
  }
  List(std::initializer_list<T> items) : List(std::vector<T>(items)) {}

  std::size_t size() const { return items_ ? items_->size() : 0; }
  bool empty() const { return size() == 0; }
  const T& operator[](std::size_t i) const { return *(*items_)[i]; }
  T& operator[](std::size_t i) {
    std::shared_ptr<T>& item = own()[i];
    if (item.use_count() > 1) item = std::make_shared<T>(*item);
    return *item;
  }
  /// Throws std::out_of_range.
  const T& at(std::size_t i) const {
    return i < size() ? (*this)[i] : throw std::out_of_range("List::at");
  }
  const T& front() const { return (*this)[0]; }
  T& front() { return (*this)[0]; }
  const T& back() const { return (*this)[size() - 1]; }
  T& back() { return (*this)[size() - 1]; }
  const_iterator begin() const { return {*this, 0}; }
  const_iterator end() const { return {*this, size()}; }
  iterator begin() { return {*this, 0}; }
  iterator end() { return {*this, size()}; }

  void reserve(std::size_t items) { own().reserve(items); }
  void clear() { items_.reset(); }
  void resize(std::size_t items) {
    while (size() < items) emplace_back();
    own().resize(items);
  }
  template <class... Arguments>
  T& emplace_back(Arguments&&... arguments) {
    return *own().emplace_back(std::make_shared<T>(std::forward<Arguments>(arguments)...));
  }
  void push_back(T item) { emplace_back(std::move(item)); }
  /// Appends an item of another list, which both then share.
  void share(const List& from, std::size_t i) { own().push_back((*from.items_)[i]); }

  /// Whether one is an unchanged copy of the other. If not, both may still have equal items.
  bool is(const List& other) const { return items_ == other.items_; }
  /// Whether a change of this item would copy it.
  bool is_shared(std::size_t i) const {
    return items_.use_count() > 1 || (*items_)[i].use_count() > 1;
  }
  /// Keeps the item as it is, for as long as the result lives.
  std::shared_ptr<const T> kept(std::size_t i) const { return (*items_)[i]; }

 private:
  using Items = std::vector<std::shared_ptr<T>>;

  Items& own() {
    if (!items_ || items_.use_count() > 1) {
      items_ = items_ ? std::make_shared<Items>(*items_) : std::make_shared<Items>();
    }
    return *items_;
  }

  std::shared_ptr<Items> items_;  // null: none
};

}  // namespace elsie::base
