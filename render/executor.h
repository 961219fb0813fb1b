#pragma once
// All cores: TBB where it was found at configure time, std::thread otherwise.

#include <memory>

#include "accel/parallel_for.h"

namespace enfilade::render {

/// thread_count 0: as many as the machine has; 1: the calling thread alone.
[[nodiscard]] std::unique_ptr<accel::Executor> make_executor(unsigned thread_count = 0);

}  // namespace enfilade::render
