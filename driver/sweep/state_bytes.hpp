// SPDX-License-Identifier: Apache-2.0
// Members of an object as bytes and back, for what declares `fields(archive)` and hands its members
// to the archive: a StateWriter or a StateReader.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>

namespace slipbench::driver::sweep {

/// Writes members one after the other: numbers in the machine's order of bytes, of arrays those
/// that are not 0, whatever grows after its size.
class StateWriter {
 public:
  void operator()(auto&... members) { (put(members), ...); }
  const std::string& bytes() const { return bytes_; }

 private:
  template <class T>
  requires std::is_arithmetic_v<T>
  void put(T number) {
    std::array<char, sizeof number> own{};
    std::memcpy(own.data(), &number, sizeof number);
    bytes_.append(own.data(), own.size());
  }
  void put(auto& object) requires requires { object.fields(*this); }
  { object.fields(*this); }
  template <class T, std::size_t kSize>
  void put(std::array<T, kSize>& numbers) {
    std::uint32_t count = 0;
    for (const T number : numbers) count += number != 0 ? 1 : 0;
    put(count);
    for (std::uint32_t i = 0; i < kSize; ++i) {
      if (numbers[i] != 0) (*this)(i, numbers[i]);
    }
  }
  template <class Key, class T>
  void put(std::map<Key, T>& map) {
    put(map.size());
    for (auto& [key, value] : map) {
      put(key);
      put(value);
    }
  }
  void put(auto& list) requires requires { list.resize(0); }
  {
    put(list.size());
    for (auto& one : list) put(one);
  }

  std::string bytes_;
};

/// Reads what a StateWriter wrote into members of the same types.
class StateReader {
 public:
  explicit StateReader(std::string_view bytes) : bytes_(bytes) {}

  void operator()(auto&... members) { (get(members), ...); }
  /// Tells whether all bytes were read and none was lacking.
  bool complete() const { return sound_ && bytes_.empty(); }

 private:
  template <class T>
  requires std::is_arithmetic_v<T>
  void get(T& number) {
    if (bytes_.size() < sizeof number) {
      sound_ = false;
      number = 0;
      return;
    }
    std::memcpy(&number, bytes_.data(), sizeof number);
    bytes_.remove_prefix(sizeof number);
  }
  void get(auto& object) requires requires { object.fields(*this); }
  { object.fields(*this); }
  template <class T, std::size_t kSize>
  void get(std::array<T, kSize>& numbers) {
    numbers.fill(0);
    std::uint32_t i = 0;
    for (std::uint32_t left = size<std::uint32_t>(); left > 0; --left) {
      get(i);
      sound_ = sound_ && i < kSize;
      get(numbers[i < kSize ? i : 0]);
    }
  }
  template <class Key, class T>
  void get(std::map<Key, T>& map) {
    map.clear();
    for (auto left = size<std::size_t>(); left > 0; --left) {
      Key key{};
      get(key);
      get(map[key]);
    }
  }
  void get(auto& list) requires requires { list.resize(0); }
  {
    list.resize(size<std::size_t>());
    for (auto& one : list) get(one);
  }

  /// Reads how many follow. Each takes a byte at least: more than that would be a damaged size.
  template <class T>
  T size() {
    T count = 0;
    get(count);
    sound_ = sound_ && count <= bytes_.size();
    return sound_ ? count : 0;
  }

  std::string_view bytes_;
  bool sound_ = true;
};

}  // namespace slipbench::driver::sweep
