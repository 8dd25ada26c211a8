// SPDX-License-Identifier: GPL-3.0-or-later
// FOVEA_ADDRESS_SANITIZER, FOVEA_THREAD_SANITIZER: defined where the code is compiled with them.
#pragma once

#ifdef __SANITIZE_ADDRESS__  // GCC
#define FOVEA_ADDRESS_SANITIZER 1
#endif
#ifdef __SANITIZE_THREAD__
#define FOVEA_THREAD_SANITIZER 1
#endif
#if defined(__clang__)
#if __has_feature(address_sanitizer)
#define FOVEA_ADDRESS_SANITIZER 1
#endif
#if __has_feature(thread_sanitizer)
#define FOVEA_THREAD_SANITIZER 1
#endif
#endif
