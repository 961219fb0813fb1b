#pragma once
// The pictures that one run makes: their names, and all of them or none.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "render/image.h"
#include "tools/output_file.h"

namespace enfilade::tools {

/// The files of the pictures of several views, named after `output`:
/// - "out/tour/", or a folder that is there: 01-hall.png, 02-kitchen.png ... in it; the folder is made where it is
///   missing;
/// - "tour-%02d.png": tour-01.png, tour-02.png ...; %d, %2d to %9d and %02d to %09d are known;
/// - "hall.png": for one view alone.
/// Names depend on the views and their order only. \throws InputError (F113, F136) for any other name.
[[nodiscard]] std::vector<std::filesystem::path> picture_paths(const std::filesystem::path& output,
                                                               std::span<const std::string> view_names);

/// Throws InputError (F113) unless the name ends as pictures do; folders pass.
void check_picture_name(const std::filesystem::path& output);

/// Writes pictures under other names, and renames them together once all are there: a run that fails leaves none, and
/// no folder that it made.
class PictureFiles {
public:
    /// Throws InputError as `picture_paths`, and IoError where a name cannot be written.
    PictureFiles(const std::filesystem::path& output, std::span<const std::string> view_names);
    ~PictureFiles();
    PictureFiles(const PictureFiles&) = delete;
    PictureFiles& operator=(const PictureFiles&) = delete;

    [[nodiscard]] const std::vector<std::filesystem::path>& paths() const { return paths_; }
    void write(std::size_t picture, const render::Image& image);
    void commit();

private:
    std::filesystem::path made_folder_;  ///< empty: it was there
    std::vector<std::filesystem::path> paths_;
    std::vector<std::unique_ptr<OutputFile>> files_;
};

}  // namespace enfilade::tools
