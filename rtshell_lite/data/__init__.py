"""What travels over data ports: types, values and their octets; being a data port oneself."""
