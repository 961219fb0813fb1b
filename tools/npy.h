#pragma once
// Arrays of numpy in files (.npy, formats 1.0 to 3.0), as docs/queries.md uses them. Needs the standard library alone.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace enfilade::tools {

/// What stands before the numbers.
struct NpyHeader {
    std::string descr;                 ///< the type, "<f4" for instance; "[" for one of several fields
    bool is_fortran = false;           ///< columns one after the other
    std::vector<std::uint64_t> shape;  ///< below 2^63 each
    std::uint64_t data_offset = 0;     ///< bytes from the file's beginning
};

/// The most bytes that a header may need; numpy's own have a hundred.
inline constexpr std::size_t longest_npy_header = std::size_t(1) << 16;

/// Reads a header. `head`: the file's first bytes, all or the first `longest_npy_header` of them; `file`: its name, for
/// what is said. Throws InputError F140 where it is none.
[[nodiscard]] NpyHeader parse_npy_header(std::string_view head, const std::string& file);

/// A file of rays, (n, 6) or (n, 7) little-endian float32 or float64 in C order: origin, direction, and the maximal
/// distance. It is read where it is asked for, by any number of threads at once; nothing of it is kept.
class RayFile {
public:
    /// Throws InputError F140-F144 for a file that is no such array, IoError for one that cannot be read.
    explicit RayFile(const std::filesystem::path& path);
    ~RayFile();
    RayFile(const RayFile&) = delete;
    RayFile& operator=(const RayFile&) = delete;

    [[nodiscard]] std::uint64_t count() const { return count_; }
    [[nodiscard]] bool has_distance() const { return columns_ == 7; }
    [[nodiscard]] std::size_t columns() const { return columns_; }
    [[nodiscard]] std::size_t ray_bytes() const { return columns_ * number_bytes_; }

    /// Rays [first, first + n), row by row; numbers: [n * columns()]. Throws IoError, also where the file has shrunk.
    /// \pre first + n <= count()
    void read(std::uint64_t first, std::span<double> numbers) const;

private:
    std::filesystem::path path_;
    int descriptor_ = -1;
    std::uint64_t count_ = 0;
    std::size_t columns_ = 6;
    std::size_t number_bytes_ = 8;
    std::uint64_t offset_ = 0;
};

/// One field of a record; an empty name is padding.
struct NpyField {
    std::string name;
    std::string type;         ///< "<f8"
    std::uint32_t count = 1;  ///< of numbers in the field
};

/// A one-dimensional array written in pieces, whose length may be known only at the end.
class NpyWriter {
public:
    /// Of records, or of numbers where there is one field without a name. element_bytes: what the fields take together.
    /// Throws IoError.
    NpyWriter(const std::filesystem::path& path, std::span<const NpyField> fields, std::size_t element_bytes);
    ~NpyWriter();
    NpyWriter(const NpyWriter&) = delete;
    NpyWriter& operator=(const NpyWriter&) = delete;

    /// Elements from `first` on. May be called by several threads for different places. Throws IoError.
    void write(std::uint64_t first, std::span<const std::byte> elements) const;
    /// Writes the header: from now on the file is an array of that length. Throws IoError.
    void finish(std::uint64_t count);

private:
    [[nodiscard]] std::string header(std::uint64_t count) const;
    void write_at(std::uint64_t offset, std::span<const std::byte> bytes) const;

    std::filesystem::path path_;
    std::string descr_;
    std::size_t element_bytes_;
    std::uint64_t data_offset_ = 0;
    int descriptor_ = -1;
};

}  // namespace enfilade::tools
