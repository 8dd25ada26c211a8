# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference backend: depth buffer and strokes drawn natively, the same picture on every machine."""

from .. import native


def Backend():
    return native.load().CpuBackend()
