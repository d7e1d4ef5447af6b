struct Twice { int x; };
