"""What writes the files that are generated, in a checkout."""
