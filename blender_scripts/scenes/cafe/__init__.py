# SPDX-License-Identifier: GPL-3.0-or-later
"""The corner cafe: a round tower with the door, a cone of scales, a wing with a shop window under a curved awning."""

from . import joinery, roofs, shopfront, walls


def build():
    walls.build()
    joinery.build()
    roofs.build()
    shopfront.build()
