#include "tools/output_file.h"

#include <unistd.h>

#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include "base/error.h"

namespace enfilade::tools {

namespace fs = std::filesystem;

fs::path output_path(const fs::path& path) {
    std::error_code ignored;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ignored))
        throw IoError("The folder " + folder.string() + " does not exist: make it, or choose another place for " +
                      path.filename().string() + ".");
    if (path.filename().empty() || fs::is_directory(path, ignored))
        throw IoError(path.string() + " is a folder: give the name of a file.");
    if (!fs::exists(path, ignored)) return path;
    if (!fs::is_regular_file(path, ignored)) throw IoError(path.string() + " is not a file: give the name of one.");
    return fs::canonical(path);
}

OutputFile::OutputFile(const fs::path& path)
    : path_(output_path(path)),
      temporary_(path_.parent_path() / (".enfilade-" + std::to_string(getpid()) + "-" + path_.filename().string())) {}

OutputFile::~OutputFile() {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void OutputFile::commit() {
    std::error_code error;
    fs::rename(temporary_, path_, error);
    if (error) throw IoError(path_.string() + " cannot be written: " + error.message() + ".");
    temporary_.clear();
}

void write_text(const fs::path& path, std::string_view text) {
    OutputFile file(path);
    std::ofstream stream(file.temporary(), std::ios::binary);
    stream.write(text.data(), std::streamsize(text.size()));
    stream.close();
    if (!stream) throw IoError(path.string() + " cannot be written: is the folder writable, and the disk not full?");
    file.commit();
}

}  // namespace enfilade::tools
