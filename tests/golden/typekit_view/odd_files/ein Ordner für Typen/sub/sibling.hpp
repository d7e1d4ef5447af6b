#pragma once
#include "../cousin.hpp"
namespace odd_files {
struct Sibling { Cousin cousin; int x; };
}
