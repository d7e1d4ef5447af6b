#pragma once
namespace bad {
struct Broken {
    double level
    int count;
};
struct /* ä */ Fixed { const int ß = 1; };
}
