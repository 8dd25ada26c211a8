# SPDX-License-Identifier: GPL-3.0-or-later
"""The GPU that Blender draws with; needs a GPU context."""

import gpu

NAMES = {"OPENGL": "OpenGL", "VULKAN": "Vulkan", "METAL": "Metal"}


def description():
    """The back end, the GPU and its driver in words: the same for the same GPU, in a process."""
    back_end, driver = gpu.platform.backend_type_get(), gpu.platform.version_get()
    return f"{gpu.platform.renderer_get()} by {NAMES.get(back_end, back_end)}, driver {driver}"
