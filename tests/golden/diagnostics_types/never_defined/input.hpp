#pragma once
#include <vector>
// Cases 57 and 82 of the type matrix.
namespace bad {
struct Later;
struct Uses {
    Later* pointer;
    std::vector<Later> list;
};
inline auto make() {
    struct Local { int a; };
    return Local{};
}
using Made = decltype(make());
struct OfLocal { Made made; };
}
