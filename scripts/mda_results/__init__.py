"""Reads the rows of a run and makes tables from them."""
