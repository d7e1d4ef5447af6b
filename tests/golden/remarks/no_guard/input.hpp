// Case 66 of the type matrix.
struct Open { int x; };
