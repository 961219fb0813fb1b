#include "accel/scene_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "accel/scene_image.h"
#include "accel/sha256.h"
#include "base/error.h"

namespace enfilade::accel {
namespace {

[[noreturn]] void fail(const std::string& what, const std::filesystem::path& path) {
    throw IoError(what + " " + path.string() + ": " + std::generic_category().message(errno));
}

class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int number() const { return number_; }
    /// Closes and says whether that worked: the last chance of a network file system to report a failed write.
    [[nodiscard]] bool close() { return ::close(std::exchange(number_, -1)) == 0; }

private:
    int number_;
};

Scene::Storage map_file(const std::filesystem::path& path) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.number() < 0) fail("cannot open", path);
    struct stat status = {};
    if (::fstat(file.number(), &status) != 0) fail("cannot read", path);
    if (!S_ISREG(status.st_mode)) throw IoError("cannot read " + path.string() + ": it is no regular file");
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size == 0) return {};
    void* address = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, file.number(), 0);
    if (address == MAP_FAILED) fail("cannot map", path);
    return {{static_cast<const std::byte*>(address),
             [size](const std::byte* p) { ::munmap(const_cast<std::byte*>(p), size); }},
            size};
}

void write_all(int file, std::span<const std::byte> bytes, const std::filesystem::path& path) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) fail("cannot write", path);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

}  // namespace

Scene open(const std::filesystem::path& path, const ReadOptions& options) {
    return detail::parse_and_validate(map_file(path), path.string(), options);
}

Scene read(std::span<const std::byte> bytes, const ReadOptions& options) {
    const std::shared_ptr<std::byte> copy = detail::allocate_aligned(bytes.size());
    if (!bytes.empty()) std::memcpy(copy.get(), bytes.data(), bytes.size());
    return detail::parse_and_validate({copy, bytes.size()}, "", options);
}

void write(const Scene& scene, const std::filesystem::path& path) {
    const std::filesystem::path temporary = path.string() + ".tmp" + std::to_string(::getpid());
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (file.number() < 0) fail("cannot create", temporary);
    try {
        write_all(file.number(), scene.bytes(), temporary);
        if (!file.close()) fail("cannot write", temporary);
        if (::rename(temporary.c_str(), path.c_str()) != 0) fail("cannot create", path);
    } catch (...) {
        ::unlink(temporary.c_str());
        throw;
    }
}

Scene strip(const Scene& scene) {
    std::vector<SceneArray> kept;
    for (const SceneArray& array : scene.arrays())
        if (array.group != Group::Model) kept.push_back(array);
    const SceneView& view = scene.view();
    return detail::parse(detail::lay_out(view.unit, {view.origin[0], view.origin[1], view.origin[2]}, kept), "");
}

std::vector<std::string> damaged_arrays(const Scene& scene, const Executor* executor) {
    const ThreadExecutor all_cores;
    const std::span<const SceneArray> arrays = scene.arrays();
    std::vector<char> damaged(arrays.size(), 0);
    (executor != nullptr ? *executor : static_cast<const Executor&>(all_cores)).run(arrays.size(), [&](std::size_t i) {
        damaged[i] = sha256(arrays[i].bytes) != arrays[i].sha256;
    });
    std::vector<std::string> names;
    for (std::size_t i = 0; i < arrays.size(); ++i)
        if (damaged[i] != 0) names.emplace_back(arrays[i].name);
    return names;
}

}  // namespace enfilade::accel
