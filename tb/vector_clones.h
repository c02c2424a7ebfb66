// SPDX-License-Identifier: Apache-2.0
/// BLYSK_VECTOR_CLONES before a function compiles it for several vector widths in one generic binary; the loader
/// takes the widest that the processor has. The function needs external linkage (clang 14 calls the narrowest
/// version of a local one), and what it calls has to be inlined to profit.
#pragma once

// The loader chooses before the thread sanitizer is ready for what it put into the choosing function.
#if !defined(__x86_64__) || defined(__SANITIZE_THREAD__)
#define BLYSK_VECTOR_CLONES
#elif defined(__clang__)
#define BLYSK_VECTOR_CLONES __attribute__((target_clones("avx512dq", "avx2", "default")))
#else
#define BLYSK_VECTOR_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#endif
