#include "backend/backend_state.hpp"
#include "backend/host_backend.hpp"

namespace sabo {

template <class Archive>
void HostBackend::archive_state(Archive& a) {
  std::vector<Vec3d> listed = listed_positions();
  BackendState state{model_.state.c0, fluid_, boundary_,   awake_,
                     body_loads_,     heat_,  pass_times_, listed};
  state.archive(a);
  if constexpr (Archive::is_reader) {
    state.check(list_radius());
    list_again(listed);
  }
}

template void HostBackend::archive_state(ArchiveWriter&);
template void HostBackend::archive_state(ArchiveReader&);

void HostBackend::list_again(std::vector<Vec3d>& listed) {
  const std::vector<std::uint32_t> awake = awake_;
  const BodyLoadSum loads = body_loads_;
  const PassTimes times = pass_times_;
  const std::vector<double> density = boundary_.density;  // of walls that find_neighbours() holds
  fluid_.position.swap(listed);
  find_neighbours();
  fluid_.position.swap(listed);
  boundary_.density = density;
  body_loads_.restore(loads);
  if (awake.size() + driven_.size() > fluid_.size())
    throw RunError("holds more particles awake than there are");
  awake_ = awake;
  asleep_count_ = fluid_.size() - awake_.size() - driven_.size();
  prepare_rows();
  pass_times_ = times;
}

}  // namespace sabo
