"""Layered drawing (Sugiyama, Tagawa, Toda 1981): where the boxes and lines of a picture are."""
