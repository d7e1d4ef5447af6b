#pragma once
// Case 36 of the type matrix.
namespace bad {
struct Wide { int a; int : 1000; int b; };
}
