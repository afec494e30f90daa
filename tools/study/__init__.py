"""The experiments behind pages of docs/: runs that resume, films, errors, figures, tables."""
