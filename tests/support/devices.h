#pragma once
// Where tests of kernels run: this machine's cores always, a card where there is one.

#include <gtest/gtest.h>

#include <memory>
#include <ostream>

#include "accel/parallel_for.h"
#include "render/cuda/device.h"

namespace enfilade::test {

enum class DeviceKind { Host, Card };

inline std::ostream& operator<<(std::ostream& out, DeviceKind kind) {
    return out << (kind == DeviceKind::Host ? "Host" : "Card");
}

/// Has `device()`; skips where there is no card, saying why. Use: class Frames : public DeviceTest {};
/// ENFILADE_ON_DEVICES(Frames); TEST_P(Frames, AreRight) { ... device() ... }
class DeviceTest : public testing::TestWithParam<DeviceKind> {
protected:
    void SetUp() override {
        if (GetParam() == DeviceKind::Host) {
            device_ = render::cuda::open_host(cores_);
            return;
        }
        if (const std::string why = render::cuda::why_no_card(0); !why.empty()) GTEST_SKIP() << why;
        device_ = render::cuda::open_card(0);
    }
    [[nodiscard]] render::cuda::Device& device() const { return *device_; }

private:
    accel::ThreadExecutor cores_{2};
    std::unique_ptr<render::cuda::Device> device_;
};

#define ENFILADE_ON_DEVICES(fixture)                                                                              \
    INSTANTIATE_TEST_SUITE_P(On, fixture,                                                                         \
                             testing::Values(enfilade::test::DeviceKind::Host, enfilade::test::DeviceKind::Card), \
                             testing::PrintToStringParamName())

}  // namespace enfilade::test
