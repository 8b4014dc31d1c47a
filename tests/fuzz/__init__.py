"""Readers of files that come from elsewhere, given thousands of damaged ones."""
