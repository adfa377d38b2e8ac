#include "io/output/state_file.hpp"

#include <cstring>
#include <fstream>
#include <memory>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>
#include <zstd.h>

#include "io/output/atomic_file.hpp"

namespace sabo {
namespace {

constexpr std::string_view magic = "sabo checkpoint\n";
constexpr std::size_t head_size = magic.size() + sizeof(std::uint32_t);
constexpr std::size_t tail_size = sizeof(std::uint32_t);
constexpr int zstd_level = 1;  // the fast end: numbers of a simulation hardly get smaller with more

std::uint32_t crc_of(std::uint32_t before, const void* data, std::size_t size) {
  return static_cast<std::uint32_t>(crc32_z(before, static_cast<const Bytef*>(data), size));
}

std::size_t checked(std::size_t code) {
  if (ZSTD_isError(code))
    throw RunError(fmt::format("cannot be unpacked: {}", ZSTD_getErrorName(code)));
  return code;
}

struct Free {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

/// Packs what it is given and hands it on.
class Packer {
 public:
  explicit Packer(std::function<void(const void*, std::size_t)> sink)
      : sink_(std::move(sink)), context_(ZSTD_createCCtx()), room_(ZSTD_CStreamOutSize()) {
    if (!context_) throw std::bad_alloc();
    checked(ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_compressionLevel, zstd_level));
    checked(ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_checksumFlag, 1));
  }
  void put(const void* data, std::size_t size) { pack(data, size, ZSTD_e_continue); }
  void finish() { pack(nullptr, 0, ZSTD_e_end); }

 private:
  void pack(const void* data, std::size_t size, ZSTD_EndDirective how) {
    ZSTD_inBuffer in{data, size, 0};
    for (bool is_done = false; !is_done;) {
      ZSTD_outBuffer out{room_.data(), room_.size(), 0};
      const std::size_t left = checked(ZSTD_compressStream2(context_.get(), &out, &in, how));
      sink_(room_.data(), out.pos);
      is_done = how == ZSTD_e_end ? left == 0 : in.pos == in.size;
    }
  }

  std::function<void(const void*, std::size_t)> sink_;
  std::unique_ptr<ZSTD_CCtx, Free> context_;
  std::vector<char> room_;
};

/// Unpacks a frame piece by piece.
class Unpacker {
 public:
  explicit Unpacker(std::string_view frame)
      : context_(ZSTD_createDCtx()), in_{frame.data(), frame.size(), 0} {
    if (!context_) throw std::bad_alloc();
  }

  std::size_t take(void* to, std::size_t size) {
    ZSTD_outBuffer out{to, size, 0};
    while (out.pos < out.size && !is_over_) {
      const std::size_t in_before = in_.pos, out_before = out.pos;
      is_over_ = checked(ZSTD_decompressStream(context_.get(), &out, &in_)) == 0;
      if (in_.pos == in_before && out.pos == out_before) break;  // the frame is cut off
    }
    return out.pos;
  }

 private:
  std::unique_ptr<ZSTD_DCtx, Free> context_;
  ZSTD_inBuffer in_;
  bool is_over_ = false;
};

std::uint32_t number_at(const std::string& bytes, std::size_t place) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}

}  // namespace

void write_state_file(const std::filesystem::path& file, std::uint32_t version,
                      const std::function<void(ArchiveWriter&)>& content) {
  AtomicFile out(file);
  std::uint32_t crc = 0;
  const auto put = [&](const void* data, std::size_t size) {
    crc = crc_of(crc, data, size);
    out.write(data, size);
  };
  put(magic.data(), magic.size());
  put(&version, sizeof version);
  Packer packer(put);
  ArchiveWriter writer([&](const void* data, std::size_t size) { packer.put(data, size); });
  content(writer);
  packer.finish();
  out.write(&crc, sizeof crc);
  out.commit();
  sync_folder(file.parent_path());
}

StateFile::StateFile(std::string bytes, std::uint32_t version) : bytes_(std::move(bytes)) {
  if (!bytes_.starts_with(magic)) throw RunError("is no checkpoint, or its beginning is damaged");
  if (bytes_.size() < head_size + tail_size) throw RunError("is cut off");
  const std::size_t end = bytes_.size() - tail_size;
  if (crc_of(0, bytes_.data(), end) != number_at(bytes_, end))
    throw RunError("is damaged or cut off: its checksum does not fit");
  if (const std::uint32_t written = number_at(bytes_, magic.size()); written != version)
    throw RunError(fmt::format("has version {} of the format, this program reads version {}",
                               written, version));
}

void StateFile::read(const std::function<void(ArchiveReader&)>& content, bool to_the_end) const {
  const std::string_view all = bytes_;
  Unpacker unpacker(all.substr(head_size, all.size() - head_size - tail_size));
  ArchiveReader reader([&](void* to, std::size_t size) { return unpacker.take(to, size); });
  content(reader);
  if (to_the_end) reader.end();
}

StateFile read_state_file(const std::filesystem::path& file, std::uint32_t version) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) throw RunError("is no file");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  const std::uintmax_t memory =
      std::uintmax_t(sysconf(_SC_PHYS_PAGES)) * std::uintmax_t(sysconf(_SC_PAGESIZE));
  if (error || size > memory) throw RunError("is larger than the memory of this machine");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw RunError("cannot be opened");
  std::string bytes(size, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream) throw RunError("cannot be read");
  return {std::move(bytes), version};
}

}  // namespace sabo
