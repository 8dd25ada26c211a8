# SPDX-License-Identifier: GPL-3.0-or-later
"""The interface: panels, menus, preferences, and the overlay of the focus heat map.
No other package imports it; operators are in the packages of their subjects."""
