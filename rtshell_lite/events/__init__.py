"""Following components: observers that they call, or polling."""
