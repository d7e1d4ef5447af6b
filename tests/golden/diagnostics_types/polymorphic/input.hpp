#pragma once
namespace bad {
struct Shape {
    virtual ~Shape() = default;
    int corners = 0;
};
struct Square : Shape {};
}
