# SPDX-License-Identifier: GPL-3.0-or-later
"""What keeps a picture from being drawn and the user can mend."""


class CannotDraw(Exception):
    """Says what is wrong and what to do about it, in a sentence for the user."""
