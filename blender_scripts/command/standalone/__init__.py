# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds for the Blenders of blender.org, which need nothing but the system: by one compiler for all systems, from
sources that are fetched once, by this machine's own Python and without root."""
