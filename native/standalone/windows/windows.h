// SPDX-License-Identifier: GPL-3.0-or-later
// Windows' own header, which oneTBB's include, without its macros that are words of ours. Found before it by what
// libraries.cmake says.
#pragma once

#define WIN32_LEAN_AND_MEAN
#include_next <windows.h>

#undef near
#undef far
#undef NEAR
#undef FAR
#define NEAR
#define FAR
