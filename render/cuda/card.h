#pragma once
// The CUDA cards of this machine.

#include <cstddef>
#include <string>
#include <vector>

#include "base/error.h"

namespace enfilade::render::cuda {

/// A card or its driver would not do its part: exit code 3.
class CudaError : public IoError {
public:
    using IoError::IoError;
};

/// A card as its driver describes it.
struct Card {
    int number;  ///< as `--device` counts them, from 0
    std::string name;
    int major, minor;  ///< compute capability
    int multiprocessors;
    std::size_t memory_bytes;
    std::size_t l2_bytes;
    int driver_version;  ///< the newest CUDA that the driver knows: 13000 for 13.0
};

/// Whether this program holds device code: it was built where there was nvcc.
[[nodiscard]] bool has_device_code();

/// The cards that can run this program's device code, by ascending number; none without a driver, a card, or device
/// code.
[[nodiscard]] std::vector<Card> cards();

/// Why a card cannot be had, in one sentence with its remedy; empty where it can. number: as in Card
[[nodiscard]] std::string why_no_card(int number);

}  // namespace enfilade::render::cuda
