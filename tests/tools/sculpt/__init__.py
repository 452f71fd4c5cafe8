# SPDX-License-Identifier: GPL-3.0-or-later
"""Sculpting from signed distance fields: the tools and the models."""
