#include "render/embree_device.h"

#include "base/error.h"

namespace enfilade::render::detail {
namespace {

void remember_error(void* text, RTCError code, const char* message) {
    if (code != RTC_ERROR_NONE) *static_cast<std::string*>(text) = message != nullptr ? message : "unknown error";
}

}  // namespace

EmbreeDevice::EmbreeDevice() : device_(rtcNewDevice(nullptr)) {
    if (device_ == nullptr) throw IoError("Embree cannot be started on this machine");
    rtcSetDeviceErrorFunction(device_, remember_error, &error_);
}

EmbreeDevice::~EmbreeDevice() { rtcReleaseDevice(device_); }

void EmbreeDevice::require_success() const {
    if (!error_.empty()) throw IoError("Embree cannot build the scene: " + error_);
}

}  // namespace enfilade::render::detail
