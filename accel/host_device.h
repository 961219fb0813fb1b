#pragma once
// One source for CPU and GPU: functions marked so compile for both, and are always inlined on the host, so that
// a kernel built for a newer instruction set never shares a body with one built for an older set.

#if defined(__CUDACC__)
#define ENFILADE_HD __host__ __device__ __forceinline__
#else
#define ENFILADE_HD inline __attribute__((always_inline))
#endif
#if defined(__CUDACC__)
#define ENFILADE_HD_COLD __host__ __device__ __noinline__
#else
#define ENFILADE_HD_COLD __attribute__((noinline, cold))
#endif
