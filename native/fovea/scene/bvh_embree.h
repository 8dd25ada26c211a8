// SPDX-License-Identifier: GPL-3.0-or-later
// Embree 4, or 3 where that is what there is: what differs between the two. Only for scene/bvh*.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace fovea::scene {

#if RTC_VERSION_MAJOR >= 4

using QueryContext = RTCRayQueryContext;

inline void init_context(QueryContext& context) { rtcInitRayQueryContext(&context); }

/// Calls the intersect functions of what the ray may meet, which shorten it.
inline void follow_ray(RTCScene scene, RTCRayHit& ray, QueryContext& context) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    rtcIntersect1(scene, &ray, &arguments);
}

#else

using QueryContext = RTCIntersectContext;

inline void init_context(QueryContext& context) { rtcInitIntersectContext(&context); }

inline void follow_ray(RTCScene scene, RTCRayHit& ray, QueryContext& context) { rtcIntersect1(scene, &context, &ray); }

#endif

}  // namespace fovea::scene
