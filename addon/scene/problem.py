# SPDX-License-Identifier: GPL-3.0-or-later
"""The error for problems in a scene that the user can fix."""


class CannotDraw(ValueError):
    """A picture cannot be drawn; the message is one sentence for the user on the problem and its solution."""
