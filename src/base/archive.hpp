#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/error.hpp"

namespace sabo {

// State as bytes, in the order of the machine. A class with state that outlives a step lists it
// once for both directions:
//   template <class Archive> void archive(Archive& a) { a(time_, steps_); }
// Every value has its kind and size in front of it, so that bytes laid out otherwise are refused.
// What a class can rebuild from its members it leaves out, and rebuilds where
// Archive::is_reader.

template <class T, class Archive>
concept Archived = requires(T& value, Archive& a) {
  value.archive(a);
};

/// Whether a list of these is archived as one piece of bytes.
template <class T, class Archive>
concept InOnePiece = std::is_trivially_copyable_v<T> && !Archived<T, Archive>;

namespace archive_kind {
inline constexpr std::uint8_t plain = 'p', list = 'l', text = 't', choice = 'o', mark = 'm';
}

/// Writes to a sink that takes bytes as they come.
class ArchiveWriter {
 public:
  static constexpr bool is_reader = false;
  using Sink = std::function<void(const void*, std::size_t)>;

  explicit ArchiveWriter(Sink sink) : sink_(std::move(sink)) {}

  /// The members of a class in their order.
  template <class... Members>
  void operator()(Members&... members) {
    (put(members), ...);
  }

  /// A name that the reader must find in the same place.
  void mark(std::string_view name) { put_text(archive_kind::mark, name); }

  /// A list whose length the reader knows already: it reads into the entries that are there.
  template <class List>
  void fixed(List& list) {
    put(list);
  }

 private:
  void head(std::uint8_t kind, std::uint64_t size) {
    sink_(&kind, 1);
    sink_(&size, sizeof size);
  }
  void put_text(std::uint8_t kind, std::string_view text) {
    head(kind, text.size());
    sink_(text.data(), text.size());
  }

  void put(std::string& text) { put_text(archive_kind::text, text); }
  void put(bool value) {
    const std::uint8_t byte = value;
    put(byte);
  }
  template <class T>
  void put(T& value) {
    if constexpr (Archived<T, ArchiveWriter>) {
      value.archive(*this);
    } else {
      static_assert(std::is_trivially_copyable_v<T>, "list its members in archive()");
      head(archive_kind::plain, sizeof(T));
      sink_(&value, sizeof(T));
    }
  }
  template <class T>
  void put(std::optional<T>& value) {
    head(archive_kind::choice, value.has_value());
    if (value) put(*value);
  }
  template <class T>
  void put(std::vector<T>& list) {
    head(archive_kind::list, list.size());
    if constexpr (InOnePiece<T, ArchiveWriter>) {
      head(archive_kind::plain, sizeof(T));
      sink_(list.data(), list.size() * sizeof(T));
    } else {
      for (T& value : list) put(value);
    }
  }
  template <class T>
  void put(std::deque<T>& list) {
    head(archive_kind::list, list.size());
    for (T& value : list) put(value);
  }
  template <class K, class V>
  void put(std::map<K, V>& map) {
    head(archive_kind::list, map.size());
    for (auto& [key, value] : map) (*this)(key, value);
  }

  Sink sink_;
};

/// Reads what a writer has written. Throws RunError where the bytes end or are not what is asked
/// for. It takes no more memory than bytes are there, whatever size they claim.
class ArchiveReader {
 public:
  static constexpr bool is_reader = true;
  /// Fills a place with up to so many bytes; returns how many, fewer at the end only.
  using Source = std::function<std::size_t(void*, std::size_t)>;

  explicit ArchiveReader(Source source) : source_(std::move(source)) {}

  template <class... Members>
  void operator()(Members&... members) {
    (get(members), ...);
  }

  void mark(std::string_view name) {
    if (text_of(archive_kind::mark) != name)
      throw RunError("holds other things where " + std::string(name) + " should be");
  }

  /// Reads into the entries of a list. Throws RunError if it has not as many of them.
  template <class T>
  void fixed(std::vector<T>& list) {
    if (head(archive_kind::list) != list.size()) throw RunError("holds a list of another length");
    if constexpr (InOnePiece<T, ArchiveReader>) {
      expect(sizeof(T));
      take(list.data(), list.size() * sizeof(T));
    } else {
      for (T& value : list) get(value);
    }
  }

  /// Throws RunError if anything is left.
  void end() {
    std::uint8_t byte = 0;
    if (source_(&byte, 1) != 0) throw RunError("goes on after its end");
  }

 private:
  static constexpr std::size_t part = 1 << 20;  // bytes taken at once

  void take(void* to, std::size_t size) {
    if (source_(to, size) != size) throw RunError("ends too early");
  }
  std::uint64_t head(std::uint8_t expected) {
    std::uint8_t kind = 0;
    std::uint64_t size = 0;
    take(&kind, 1);
    take(&size, sizeof size);
    if (kind != expected) throw RunError("is laid out otherwise");
    return size;
  }
  void expect(std::size_t size) {
    if (head(archive_kind::plain) != size) throw RunError("holds numbers of another kind");
  }
  /// Appends entries of a list as their bytes come.
  template <class List>
  void take_list(List& list, std::uint64_t count) {
    constexpr std::size_t at_once = std::max<std::size_t>(1, part / sizeof(list[0]));
    while (list.size() < count) {
      const std::size_t before = list.size();
      const std::size_t more = std::min<std::uint64_t>(at_once, count - before);
      list.resize(before + more);
      take(list.data() + before, more * sizeof(list[0]));
    }
  }
  std::string text_of(std::uint8_t kind) {
    std::string text;
    take_list(text, head(kind));
    return text;
  }

  void get(std::string& text) { text = text_of(archive_kind::text); }
  void get(bool& value) {
    std::uint8_t byte = 0;
    get(byte);
    if (byte > 1) throw RunError("holds a number where yes or no should be");
    value = byte == 1;
  }
  template <class T>
  void get(T& value) {
    if constexpr (Archived<T, ArchiveReader>) {
      value.archive(*this);
    } else {
      static_assert(std::is_trivially_copyable_v<T>, "list its members in archive()");
      expect(sizeof(T));
      take(&value, sizeof(T));
    }
  }
  template <class T>
  void get(std::optional<T>& value) {
    value.reset();
    if (head(archive_kind::choice) != 0) get(value.emplace());
  }
  template <class T>
  void get(std::vector<T>& list) {
    const std::uint64_t count = head(archive_kind::list);
    if constexpr (InOnePiece<T, ArchiveReader>) {
      expect(sizeof(T));
      list.clear();
      take_list(list, count);
    } else {
      get_each(list, count);
    }
  }
  template <class T>
  void get(std::deque<T>& list) {
    get_each(list, head(archive_kind::list));
  }
  /// Entries that are there are read into: they may hold what is not archived.
  template <class List>
  void get_each(List& list, std::uint64_t count) {
    if (list.size() > count) list.resize(count);
    for (auto& value : list) get(value);
    while (list.size() < count) get(list.emplace_back());
  }
  template <class K, class V>
  void get(std::map<K, V>& map) {
    map.clear();
    for (std::uint64_t left = head(archive_kind::list); left > 0; --left) {
      K key{};
      get(key);
      get(map[key]);
    }
  }

  Source source_;
};

}  // namespace sabo
