#pragma once
#include <string>
namespace bad {
struct Second {
    std::string name;
    std::vector<std::string> names;
    std::optional<int> age;
    std::vectr<int> slip;
};
}
