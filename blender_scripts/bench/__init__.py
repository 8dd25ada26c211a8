# SPDX-License-Identifier: GPL-3.0-or-later
"""Benchmarks: `fovea bench NAME`. They print measurements and do not fail on bad ones; tests check limits elsewhere."""
