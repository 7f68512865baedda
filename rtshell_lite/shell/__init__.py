"""What a shell needs: set-up, completion, rtsh, installing and unpacking, manual pages."""
