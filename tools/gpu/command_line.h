#pragma once
// The program without its main function.

#include <cstddef>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace enfilade::tools::gpu {

/// Runs `enfilade_gpu ARGUMENTS`: report to `out`, progress to `log`. 0: all is right; 1: a device's answers are wrong.
/// \throws InputError for arguments and files that are wrong (exit 2), IoError and CudaError for a file or device that
/// would not do its part (exit 3)
[[nodiscard]] int run(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& log);

}  // namespace enfilade::tools::gpu
