#pragma once
#include "library/box.hpp"
#include <vector>
namespace bad {
struct Robot {
    std::vector<library::Box<library::Locked>> parts;
    const char* name = nullptr;
};
}
