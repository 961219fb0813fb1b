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
/// Compiled for both, and inlined where the compiler thinks that it pays: for functions in unnamed namespaces alone, of
/// which each instruction set has its own.
#if defined(__CUDACC__)
#define ENFILADE_HD_FREE __host__ __device__
#else
#define ENFILADE_HD_FREE
#endif
