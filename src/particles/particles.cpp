#include "particles/particles.hpp"

#include "base/error.hpp"

namespace sabo {
namespace {

template <class T>
std::vector<T> gathered(const std::vector<T>& source, const std::vector<std::uint32_t>& order) {
  std::vector<T> result(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) result[k] = source[order[k]];
  return result;
}

}  // namespace

void Particles::resize(std::size_t count) {
#define SABO_RESIZE_FIELD(type, name, unit, meaning, is_shown) name.resize(count);
  SABO_PARTICLE_FIELDS(SABO_RESIZE_FIELD)
#undef SABO_RESIZE_FIELD
}

void Particles::permute(const std::vector<std::uint32_t>& order) {
#define SABO_PERMUTE_FIELD(type, name, unit, meaning, is_shown) name = gathered(name, order);
  SABO_PARTICLE_FIELDS(SABO_PERMUTE_FIELD)
#undef SABO_PERMUTE_FIELD
}

void Particles::put(const Particles& source, const std::vector<std::uint32_t>& rows) {
#define SABO_PUT_FIELD(type, name, unit, meaning, is_shown) \
  for (std::size_t k = 0; k < rows.size(); ++k) name[rows[k]] = source.name[k];
  SABO_PARTICLE_FIELDS(SABO_PUT_FIELD)
#undef SABO_PUT_FIELD
}

void Particles::append(const Particles& source, const std::vector<std::uint32_t>& rows) {
#define SABO_APPEND_FIELD(type, name, unit, meaning, is_shown) \
  for (const std::uint32_t row : rows) name.push_back(source.name[row]);
  SABO_PARTICLE_FIELDS(SABO_APPEND_FIELD)
#undef SABO_APPEND_FIELD
}

void Particles::append(const Particles& source) {
#define SABO_APPEND_FIELD(type, name, unit, meaning, is_shown) \
  name.insert(name.end(), source.name.begin(), source.name.end());
  SABO_PARTICLE_FIELDS(SABO_APPEND_FIELD)
#undef SABO_APPEND_FIELD
}

void Particles::check_lengths() const {
#define SABO_CHECK_FIELD(type, name, unit, meaning, is_shown) \
  if (name.size() != size()) throw RunError("holds arrays of particles that differ in length");
  SABO_PARTICLE_FIELDS(SABO_CHECK_FIELD)
#undef SABO_CHECK_FIELD
}

}  // namespace sabo
