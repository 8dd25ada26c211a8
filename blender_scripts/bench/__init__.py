"""Benchmarks: `fovea bench NAME`. They print numbers and judge nothing; tests do that elsewhere."""
