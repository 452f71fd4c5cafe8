# SPDX-License-Identifier: GPL-3.0-or-later
"""A small brush simulation: strips of paint, dark at the left, light at the right."""
