#pragma once
namespace bad {
struct Broken {
    double level
    int count;
};
struct Unknown { Missing field; };
}
