#pragma once
// Case 49 of the type matrix.
namespace bad {
struct [[oro::make("Size(0)")]] Misspelt { explicit Misspelt(int n) : size(n) {} int size; };
struct [[oro::make("0")]] Other { explicit Other(int n) : size(n) {} int size; };
class Outer {
public:
    /// @make Inner(2, 3)
    struct Inner { Inner(int a, int b) : sum(a + b) {} int sum; };
};
struct [[oro::make("Hidden(1)")]] Hidden {
    int size;

private:
    explicit Hidden(int n) : size(n) {}
};
struct Holder {
    struct [[oro::make("{1}")]] { int size; } unnamed;
};
struct [[oro::make("Cut(")]] Cut { explicit Cut(int n) : size(n) {} int size; };
}
