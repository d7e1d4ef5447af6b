#pragma once
#include <memory>
#include <vector>
// Case 31 of the type matrix.
namespace bad {
struct Node { [[oro::by_value]] std::shared_ptr<Node> next; };
struct Tree;
struct Branch { [[oro::by_value]] std::shared_ptr<Tree> tree; };
struct Tree { std::vector<Branch> branches; };
struct Outer { struct { [[oro::by_value]] std::shared_ptr<Outer> next; } inner; };
struct Fine { [[oro::by_value]] std::shared_ptr<int> number; std::vector<Fine> children; };
}
