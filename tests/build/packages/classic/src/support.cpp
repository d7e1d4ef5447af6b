#include "support.hpp"
int classicAnswer() { return 42; }
