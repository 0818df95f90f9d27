"""The algorithms that are kept to compare: the paper's, and SciPy's constrained and global optimisers."""
