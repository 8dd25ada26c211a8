# SPDX-License-Identifier: GPL-3.0-or-later
"""Script for a child process: creates an OpenGL 4.3 context as Blender does in background mode, prints its renderer;
with --kind the word hardware or software before it.

Blender aborts if this fails, so it is tried in a separate process first. Exit code 0: usable.
"""

import ctypes
import sys
from ctypes import byref, c_char_p, c_int, c_void_p

SURFACELESS = 0x31DD
OPENGL_API = 0x30A2
RENDERER = 0x1F01
ATTRIBUTES = (0x3033, 0x0001, 0x3040, 0x0008, 0x3024, 8, 0x3023, 8, 0x3022, 8, 0x3038)  # pbuffer, OpenGL, RGB 8
CORE_4_3 = (0x3098, 4, 0x30FB, 3, 0x30FD, 1, 0x3038)
SURFACE = (0x3057, 1, 0x3056, 1, 0x3038)  # width and height 1 pixel

SOFTWARE = ("llvmpipe", "softpipe", "swrast", "software")  # in the names of renderers on the CPU


def is_software(renderer):
    return any(name in renderer.lower() for name in SOFTWARE)


def _ints(values):
    return (c_int * len(values))(*values)


def _function(library, name, result, *arguments):
    function = getattr(library, name)
    function.restype = result
    function.argtypes = arguments
    return function


def renderer():
    """GL_RENDERER of a new context; OSError if no context can be created."""
    egl = ctypes.CDLL("libEGL.so.1")
    address = _function(egl, "eglGetProcAddress", c_void_p, c_char_p)
    platform_display = address(b"eglGetPlatformDisplayEXT")
    if not platform_display:
        raise OSError("no EGL platforms")
    display = ctypes.CFUNCTYPE(c_void_p, c_int, c_void_p, c_void_p)(platform_display)(SURFACELESS, None, None)
    if not _function(egl, "eglInitialize", c_int, c_void_p, c_void_p, c_void_p)(display, None, None):
        raise OSError("no EGL display")
    config, count = c_void_p(), c_int()
    choose = _function(egl, "eglChooseConfig", c_int, c_void_p, c_void_p, c_void_p, c_int, c_void_p)
    choose(display, _ints(ATTRIBUTES), byref(config), 1, byref(count))
    _function(egl, "eglBindAPI", c_int, c_int)(OPENGL_API)
    create = _function(egl, "eglCreateContext", c_void_p, c_void_p, c_void_p, c_void_p, c_void_p)
    context = create(display, config, None, _ints(CORE_4_3))
    surface_of = _function(egl, "eglCreatePbufferSurface", c_void_p, c_void_p, c_void_p, c_void_p)
    surface = surface_of(display, config, _ints(SURFACE))
    current = _function(egl, "eglMakeCurrent", c_int, c_void_p, c_void_p, c_void_p, c_void_p)
    if not count.value or not context or not current(display, surface, surface, context):
        raise OSError("no OpenGL 4.3 context")
    text = ctypes.CFUNCTYPE(c_char_p, c_int)(address(b"glGetString"))(RENDERER)
    if not text:
        raise OSError("OpenGL does not answer")
    return text.decode(errors="replace")


if __name__ == "__main__":
    try:
        found = renderer()
        kind = "software" if is_software(found) else "hardware"
        print(*([kind, found] if sys.argv[1:] == ["--kind"] else [found]))
    except (OSError, AttributeError) as error:
        sys.exit(str(error))
