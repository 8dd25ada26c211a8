# SPDX-License-Identifier: GPL-3.0-or-later
"""The interface: panels, menus, preferences, and the overlay that shows focus as colors.
Nothing of the add-on imports it; operators stand with what they are about."""
