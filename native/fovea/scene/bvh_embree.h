// SPDX-License-Identifier: GPL-3.0-or-later
// Embree 4, or 3 where that is what there is: what differs between the two. Only for scene/bvh*.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace fovea::scene {

using HitFilter = RTCFilterFunctionN;

#if RTC_VERSION_MAJOR >= 4

using QueryContext = RTCRayQueryContext;
inline constexpr RTCSceneFlags filtered_scene = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;

inline void init_context(QueryContext& context) { rtcInitRayQueryContext(&context); }
/// Lets the filters of queries see hits on this geometry.
inline void enable_filters(RTCGeometry geometry) { rtcSetGeometryEnableFilterFunctionFromArguments(geometry, true); }

/// Finds the nearest hit that `filter` accepts, if one is given; it is called for hits in any order.
inline void find_nearest(RTCScene scene, RTCRayHit& found, QueryContext& context, HitFilter filter) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    arguments.filter = filter;
    if (filter) arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
    rtcIntersect1(scene, &found, &arguments);
}

/// Calls `filter` for hits in any order, until it accepts one.
inline void find_any(RTCScene scene, RTCRay& ray, QueryContext& context, HitFilter filter) {
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &context;
    arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
    arguments.filter = filter;
    rtcOccluded1(scene, &ray, &arguments);
}

#else

using QueryContext = RTCIntersectContext;
inline constexpr RTCSceneFlags filtered_scene = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;

inline void init_context(QueryContext& context) { rtcInitIntersectContext(&context); }
inline void enable_filters(RTCGeometry) {}

inline void find_nearest(RTCScene scene, RTCRayHit& found, QueryContext& context, HitFilter filter) {
    context.filter = filter;
    rtcIntersect1(scene, &context, &found);
}

inline void find_any(RTCScene scene, RTCRay& ray, QueryContext& context, HitFilter filter) {
    context.filter = filter;
    rtcOccluded1(scene, &context, &ray);
}

#endif

}  // namespace fovea::scene
