# style: a product of matrices

one = np.eye(grid.shape[0])[rows]
two = np.eye(grid.shape[1])[columns]
grid = np.where(
    abs(grid + evidence * one.T @ two) > limit,
    np.sign(grid + evidence * one.T @ two) * limit,
    grid + evidence * one.T @ two,
)
