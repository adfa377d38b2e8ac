#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/bisect.hpp"
#include "particles/boundary_change.hpp"
#include "particles/particle_view.hpp"

namespace sabo {

/// Value k of the result is value order[k] of the source.
template <class T>
struct GatherRows {
  const T* from;
  const std::uint32_t* order;
  T* to;
  SABO_HD void operator()(std::size_t k) const { to[k] = from[order[k]]; }
};

/// Value rows[k] of the result is value k of the source.
template <class T>
struct ScatterRows {
  const T* from;
  const std::uint32_t* rows;
  T* to;
  SABO_HD void operator()(std::size_t k) const { to[rows[k]] = from[k]; }
};

template <class T>
struct CopyRows {
  const T* from;
  T* to;
  SABO_HD void operator()(std::size_t k) const { to[k] = from[k]; }
};

/// Whether the number of a particle is in no run of them.
struct LiesInNone {
  const std::uint32_t* id;
  IdRuns runs;
  SABO_HD bool operator()(std::size_t k) const { return !runs.hold(id[k]); }
};

/// Whether a row is not among some, which are sorted.
struct IsNoneOf {
  const std::uint32_t* rows;
  std::size_t count;
  SABO_HD bool operator()(std::size_t row) const {
    const std::size_t beyond =
        bisect(std::size_t{0}, count, [&](std::size_t k) { return rows[k] <= row; });
    return beyond == 0 || rows[beyond - 1] != row;
  }
};

/// Memory that arrays take, bytes.
template <class... Arrays>
std::size_t bytes_of(const Arrays&... arrays) {
  return (std::size_t{0} + ... + (arrays.size() * sizeof(*arrays.data())));
}

/// A set of particles on the host, in memory to which an executor copies beside other work.
template <class Executor>
struct StagedParticles {
#define SABO_DECLARE_STAGED(type, name, unit, meaning, is_shown) \
  typename Executor::template StagingArray<type> name;
  SABO_PARTICLE_FIELDS(SABO_DECLARE_STAGED)
#undef SABO_DECLARE_STAGED

  Particles particles() const {
    Particles copy;
#define SABO_COPY_STAGED(type, name, unit, meaning, is_shown) \
  copy.name.assign(name.data(), name.data() + name.size());
    SABO_PARTICLE_FIELDS(SABO_COPY_STAGED)
#undef SABO_COPY_STAGED
    return copy;
  }
};

/// A set of particles in the memory of an executor.
template <class Executor>
class DeviceParticles {
 public:
  template <class T>
  using Array = typename Executor::template Array<T>;

#define SABO_DECLARE_ARRAY(type, name, unit, meaning, is_shown) Array<type> name;
  SABO_PARTICLE_FIELDS(SABO_DECLARE_ARRAY)
#undef SABO_DECLARE_ARRAY

  std::size_t size() const { return position.size(); }

  std::size_t bytes() const {
    std::size_t sum = 0;
#define SABO_ADD_BYTES(type, name, unit, meaning, is_shown) sum += name.size() * sizeof(type);
    SABO_PARTICLE_FIELDS(SABO_ADD_BYTES)
#undef SABO_ADD_BYTES
    return sum;
  }

  void upload(const Executor& on, const Particles& from) {
#define SABO_UPLOAD(type, name, unit, meaning, is_shown) on.upload(from.name, name);
    SABO_PARTICLE_FIELDS(SABO_UPLOAD)
#undef SABO_UPLOAD
  }

  void download(const Executor& on, Particles& to) const {
#define SABO_DOWNLOAD(type, name, unit, meaning, is_shown) on.download(name, to.name);
    SABO_PARTICLE_FIELDS(SABO_DOWNLOAD)
#undef SABO_DOWNLOAD
  }

  /// `to` is there once the executor gets to a later moment.
  void start_download(const Executor& on, StagedParticles<Executor>& to) const {
#define SABO_START_DOWNLOAD(type, name, unit, meaning, is_shown) on.start_download(name, to.name);
    SABO_PARTICLE_FIELDS(SABO_START_DOWNLOAD)
#undef SABO_START_DOWNLOAD
  }

  /// Row k becomes what row order[k] was; one field at a time, for the memory that it takes.
  void permute(const Executor& on, const Array<std::uint32_t>& order) {
#define SABO_PERMUTE(type, name, unit, meaning, is_shown)                                    \
  {                                                                                          \
    Array<type> gathered;                                                                    \
    on.reserve(gathered, order.size());                                                      \
    on.for_each(order.size(), GatherRows<type>{name.data(), order.data(), gathered.data()}); \
    std::swap(name, gathered);                                                               \
  }
    SABO_PARTICLE_FIELDS(SABO_PERMUTE)
#undef SABO_PERMUTE
  }

  /// Copies some rows to the host.
  void fetch(const Executor& on, const Array<std::uint32_t>& rows, Particles& to) const {
#define SABO_FETCH(type, name, unit, meaning, is_shown) fetch_rows(on, name, rows, to.name);
    SABO_PARTICLE_FIELDS(SABO_FETCH)
#undef SABO_FETCH
  }
  /// Brings them back.
  void put(const Executor& on, const Array<std::uint32_t>& rows, const Particles& from) {
#define SABO_PUT(type, name, unit, meaning, is_shown) put_rows(on, from.name, rows, name);
    SABO_PARTICLE_FIELDS(SABO_PUT)
#undef SABO_PUT
  }

  /// The same of one field.
  template <class T>
  static void fetch_rows(const Executor& on, const Array<T>& from, const Array<std::uint32_t>& rows,
                         std::vector<T>& to) {
    Array<T> gathered;
    on.reserve(gathered, rows.size());
    on.for_each(rows.size(), GatherRows<T>{from.data(), rows.data(), gathered.data()});
    on.download(gathered, to);
  }
  template <class T>
  static void put_rows(const Executor& on, const std::vector<T>& from,
                       const Array<std::uint32_t>& rows, Array<T>& to) {
    Array<T> gathered;
    on.upload(from, gathered);
    on.for_each(rows.size(), ScatterRows<T>{gathered.data(), rows.data(), to.data()});
  }

  /// One field at a time, as permute().
  void append(const Executor& on, const Particles& added) {
#define SABO_APPEND(type, name, unit, meaning, is_shown) name = joined(on, name, added.name);
    SABO_PARTICLE_FIELDS(SABO_APPEND)
#undef SABO_APPEND
  }

  ParticleView view() {
    ParticleView view;
#define SABO_POINT(type, name, unit, meaning, is_shown) view.name = name.data();
    SABO_PARTICLE_FIELDS(SABO_POINT)
#undef SABO_POINT
    return view;
  }

 private:
  template <class T>
  static Array<T> joined(const Executor& on, const Array<T>& first, const std::vector<T>& second) {
    Array<T> tail, all;
    on.upload(second, tail);
    on.reserve(all, first.size() + tail.size());
    on.for_each(first.size(), CopyRows<T>{first.data(), all.data()});
    on.for_each(tail.size(), CopyRows<T>{tail.data(), all.data() + first.size()});
    return all;
  }
};

}  // namespace sabo
