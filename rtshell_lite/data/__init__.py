"""What travels over data ports: types, values and their bytes; our own ends of such connections."""
