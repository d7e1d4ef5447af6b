#pragma once
namespace bad {
union Number { int whole; float part; };
struct Word {
    unsigned low : 3;
    unsigned : 0;
    Number number;
    union { int a; float b; };
    enum { kOne, kTwo } choice;
    struct { int x; } unnamed;
};
}
