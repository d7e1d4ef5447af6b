#pragma once
namespace bad {
struct First {
    std::vector<double> list;
    uint8_t flags;
};
}
