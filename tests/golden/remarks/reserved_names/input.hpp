#pragma once
// Case 59 of the type matrix.
namespace remarks {
struct _Upper { int two__bars; int _fine; };
struct Fine { int _Bad; };
}
