# SPDX-License-Identifier: GPL-3.0-or-later
"""Benchmarks: `fovea bench NAME`. They print numbers and judge nothing; tests do that elsewhere."""
