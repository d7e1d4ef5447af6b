#pragma once
namespace bad {
struct Broken {
    double level
    int count;
};
struct /* ä */ Fixed { volatile int ß = 1; };
}
