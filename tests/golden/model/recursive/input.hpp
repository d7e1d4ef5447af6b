#pragma once
#include <string>
#include <vector>
namespace demo { struct Node { std::string name; std::vector<Node> children; }; }
