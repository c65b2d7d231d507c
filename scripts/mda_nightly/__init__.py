"""Nightly tracking: sessions of interleaved samples, what they prove, and their history."""
