#pragma once

/// This header hides the difference between Embree 3 and 4: the way in which a query is told what
/// it may assume about its rays. AEROSTAT_EMBREE is the first number of the version.
#if AEROSTAT_EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

namespace aerostat::embree {

#if AEROSTAT_EMBREE == 3

/// A query of one thread, which can be used any number of times.
class Query {
 public:
  explicit Query(bool coherent = false) {
    rtcInitIntersectContext(&context_);
    context_.flags =
        coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  }

  void closest_1(RTCScene scene, RTCRayHit& hit) { rtcIntersect1(scene, &context_, &hit); }
  void occluded_1(RTCScene scene, RTCRay& ray) { rtcOccluded1(scene, &context_, &ray); }
  void closest(const int* valid, RTCScene scene, RTCRayHit4& hits) {
    rtcIntersect4(valid, scene, &context_, &hits);
  }
  void occluded(const int* valid, RTCScene scene, RTCRay4& rays) {
    rtcOccluded4(valid, scene, &context_, &rays);
  }
  void closest(const int* valid, RTCScene scene, RTCRayHit8& hits) {
    rtcIntersect8(valid, scene, &context_, &hits);
  }
  void occluded(const int* valid, RTCScene scene, RTCRay8& rays) {
    rtcOccluded8(valid, scene, &context_, &rays);
  }
  void closest(const int* valid, RTCScene scene, RTCRayHit16& hits) {
    rtcIntersect16(valid, scene, &context_, &hits);
  }
  void occluded(const int* valid, RTCScene scene, RTCRay16& rays) {
    rtcOccluded16(valid, scene, &context_, &rays);
  }

 private:
  RTCIntersectContext context_;
};

#else

/// A query of one thread, which can be used any number of times.
class Query {
 public:
  explicit Query(bool coherent = false) {
    rtcInitIntersectArguments(&closest_);
    rtcInitOccludedArguments(&occluded_);
    closest_.flags = occluded_.flags =
        coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
  }

  void closest_1(RTCScene scene, RTCRayHit& hit) { rtcIntersect1(scene, &hit, &closest_); }
  void occluded_1(RTCScene scene, RTCRay& ray) { rtcOccluded1(scene, &ray, &occluded_); }
  void closest(const int* valid, RTCScene scene, RTCRayHit4& hits) {
    rtcIntersect4(valid, scene, &hits, &closest_);
  }
  void occluded(const int* valid, RTCScene scene, RTCRay4& rays) {
    rtcOccluded4(valid, scene, &rays, &occluded_);
  }
  void closest(const int* valid, RTCScene scene, RTCRayHit8& hits) {
    rtcIntersect8(valid, scene, &hits, &closest_);
  }
  void occluded(const int* valid, RTCScene scene, RTCRay8& rays) {
    rtcOccluded8(valid, scene, &rays, &occluded_);
  }
  void closest(const int* valid, RTCScene scene, RTCRayHit16& hits) {
    rtcIntersect16(valid, scene, &hits, &closest_);
  }
  void occluded(const int* valid, RTCScene scene, RTCRay16& rays) {
    rtcOccluded16(valid, scene, &rays, &occluded_);
  }

 private:
  RTCIntersectArguments closest_;
  RTCOccludedArguments occluded_;
};

#endif

}  // namespace aerostat::embree
