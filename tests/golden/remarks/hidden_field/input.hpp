#pragma once
// Case 70 of the type matrix.
namespace remarks {
struct Hides {
    int shown;
#ifndef __orogen
    int* hidden;
#endif
};
struct Same {
#ifdef __orogen
    int value;
#else
    int value = 3;
#endif
};
struct Renamed {
#ifdef __orogen
    int one;
#else
    int other;
#endif
};
}
