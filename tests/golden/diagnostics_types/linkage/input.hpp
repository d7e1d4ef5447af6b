#pragma once
namespace {
struct Local { int x; };
}
namespace bad {
class Outer {
    struct Hidden { int x; };
public:
    Hidden hidden;
};
enum class Later : int;
struct UsesLater { Later later; };
}
