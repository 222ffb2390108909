# SPDX-License-Identifier: MIT
"""Anchors of headings as GitHub makes them, so that links between pages hold in both places."""
import re


def github(text, separator):
    """Lower case, without punctuation, with a hyphen for each space."""
    return re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", separator)
