#include "tools/npy.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/error.h"

namespace enfilade::tools {

static_assert(std::endian::native == std::endian::little);

namespace {

[[noreturn]] void cannot_read(const std::filesystem::path& path, const char* why) {
    throw IoError(path.string() + " cannot be read: " + why + ".");
}

/// All of `bytes`, or IoError.
void read_at(int descriptor, std::uint64_t offset, std::span<std::byte> bytes, const std::filesystem::path& path) {
    while (!bytes.empty()) {
        const ssize_t size = pread(descriptor, bytes.data(), bytes.size(), off_t(offset));
        if (size < 0 && errno == EINTR) continue;
        if (size < 0) cannot_read(path, std::strerror(errno));
        if (size == 0) cannot_read(path, "it has become shorter meanwhile");
        offset += std::uint64_t(size);
        bytes = bytes.subspan(std::size_t(size));
    }
}

std::string shape_text(const std::vector<std::uint64_t>& shape) {
    std::string text = "(";
    for (std::size_t i = 0; i < shape.size(); ++i) text += (i == 0 ? "" : ", ") + std::to_string(shape[i]);
    return text + (shape.size() == 1 ? ",)" : ")");
}

/// The array that a header promises is one of rays. Throws InputError.
void check_rays(const NpyHeader& header, std::uint64_t file_bytes, const std::string& file) {
    const std::string& type = header.descr;
    const auto refuse = [&](const char* code, const std::string& sentence) { throw InputError(code, file, sentence); };
    if (type == "[")
        refuse("F141",
               "The array has named fields; rays are plain numbers: write their columns as one array of type \"<f8\".");
    if (type.find('O') != std::string::npos)
        refuse("F141", "The array holds Python objects, which are not read: write rays.astype(\"<f8\").");
    if (type != "<f4" && type != "<f8")
        refuse("F141", "The array's type is \"" + type.substr(0, 20) +
                           "\"; rays are little-endian float32 or float64: write rays.astype(\"<f8\").");
    if (header.shape.size() != 2 || (header.shape[1] != 6 && header.shape[1] != 7))
        refuse("F143", "The array's shape is " + shape_text(header.shape) +
                           "; rays are (n, 6), origin and direction, or (n, 7) with a maximal distance: write "
                           "numpy.hstack([origins, directions]).");
    if (header.is_fortran && header.shape[0] > 1)
        refuse("F142", "The array lies column by column (Fortran order): write numpy.ascontiguousarray(rays).");
    const std::uint64_t ray_bytes = header.shape[1] * (type == "<f4" ? 4 : 8);
    const std::uint64_t there = (file_bytes - header.data_offset) / ray_bytes;
    if (header.shape[0] != there || (file_bytes - header.data_offset) % ray_bytes != 0)
        refuse("F144", "The header promises " + std::to_string(header.shape[0]) + " rays and the file holds " +
                           std::to_string(there) + (header.shape[0] == there ? " and a piece of one" : "") +
                           ": it was cut off or overwritten, so write it again with numpy.save.");
}

}  // namespace

RayFile::RayFile(const std::filesystem::path& path) : path_(path) {
    descriptor_ = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) cannot_read(path, std::strerror(errno));
    try {
        struct stat status = {};
        if (fstat(descriptor_, &status) != 0) cannot_read(path, std::strerror(errno));
        if (!S_ISREG(status.st_mode)) cannot_read(path, "it is no file");
        const auto file_bytes = std::uint64_t(status.st_size);
        std::string head(std::size_t(std::min<std::uint64_t>(file_bytes, longest_npy_header)), '\0');
        read_at(descriptor_, 0, std::as_writable_bytes(std::span(head)), path);
        const NpyHeader header = parse_npy_header(head, path.string());
        check_rays(header, file_bytes, path.string());
        count_ = header.shape[0];
        columns_ = std::size_t(header.shape[1]);
        number_bytes_ = header.descr == "<f4" ? 4 : 8;
        offset_ = header.data_offset;
    } catch (...) {
        close(descriptor_);
        throw;
    }
}

RayFile::~RayFile() { close(descriptor_); }

void RayFile::read(std::uint64_t first, std::span<double> numbers) const {
    // Narrow numbers are read into the upper half of their places and widened from the front.
    const std::size_t bytes = numbers.size() * number_bytes_;
    const std::span<std::byte> all = std::as_writable_bytes(numbers);
    const std::span<std::byte> raw = all.last(bytes);
    read_at(descriptor_, offset_ + first * ray_bytes(), raw, path_);
    if (number_bytes_ == 8) return;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        float narrow = 0;
        std::memcpy(&narrow, raw.data() + 4 * i, 4);
        const double wide = narrow;
        std::memcpy(all.data() + 8 * i, &wide, 8);
    }
}

NpyWriter::NpyWriter(const std::filesystem::path& path, std::span<const NpyField> fields, std::size_t element_bytes)
    : path_(path), element_bytes_(element_bytes) {
    if (fields.size() == 1 && fields[0].name.empty()) {
        descr_ = "'" + fields[0].type + "'";
    } else {
        for (const NpyField& field : fields)
            descr_ += (descr_.empty() ? "[('" : ", ('") + field.name + "', '" + field.type + "'" +
                      (field.count > 1 ? ", (" + std::to_string(field.count) + ",))" : ")");
        descr_ += "]";
    }
    data_offset_ = header(INT64_MAX).size();
    descriptor_ = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw IoError(path.string() + " cannot be written: " + std::strerror(errno) + ".");
}

NpyWriter::~NpyWriter() {
    if (descriptor_ >= 0) close(descriptor_);
}

/// As numpy.save writes it: padded so that the numbers begin at a multiple of 64, and closed by a line end. It has one
/// length for all counts.
std::string NpyWriter::header(std::uint64_t count) const {
    std::string text = "{'descr': " + descr_ + ", 'fortran_order': False, 'shape': (" + std::to_string(count) + ",), }";
    const std::size_t most = text.size() - std::to_string(count).size() + std::to_string(INT64_MAX).size();
    const std::size_t whole = (10 + most + 1 + 63) / 64 * 64;
    text.resize(whole - 10 - 1, ' ');
    text += '\n';
    const char length[2] = {char(text.size() & 0xff), char(text.size() >> 8)};
    return std::string("\x93NUMPY\x01\x00", 8) + std::string(length, 2) + text;
}

void NpyWriter::write_at(std::uint64_t offset, std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
        const ssize_t size = pwrite(descriptor_, bytes.data(), bytes.size(), off_t(offset));
        if (size < 0 && errno == EINTR) continue;
        if (size < 0) throw IoError(path_.string() + " cannot be written: " + std::strerror(errno) + ".");
        offset += std::uint64_t(size);
        bytes = bytes.subspan(std::size_t(size));
    }
}

void NpyWriter::write(std::uint64_t first, std::span<const std::byte> elements) const {
    write_at(data_offset_ + first * element_bytes_, elements);
}

void NpyWriter::finish(std::uint64_t count) {
    const std::string head = header(count);
    write_at(0, std::as_bytes(std::span(head)));
    const int failed = close(std::exchange(descriptor_, -1));
    if (failed != 0) throw IoError(path_.string() + " cannot be written: " + std::strerror(errno) + ".");
}

}  // namespace enfilade::tools
