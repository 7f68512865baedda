"""Following components: observers that they call, and asking them again where they call nobody."""
