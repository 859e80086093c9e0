// Embree's objects, given back when their owner goes.
#pragma once

#include <embree3/rtcore.h>

#include <memory>

namespace rt {

/// Owns one reference.
template <typename T, void (*release)(T)>
struct Releaser {
    using pointer = T;
    void operator()(T handle) const { release(handle); }
};
using DeviceHandle = std::unique_ptr<RTCDevice, Releaser<RTCDevice, rtcReleaseDevice>>;
using SceneHandle = std::unique_ptr<RTCScene, Releaser<RTCScene, rtcReleaseScene>>;
using BvhHandle = std::unique_ptr<RTCBVH, Releaser<RTCBVH, rtcReleaseBVH>>;
using GeometryHandle = std::unique_ptr<RTCGeometry, Releaser<RTCGeometry, rtcReleaseGeometry>>;

}  // namespace rt
