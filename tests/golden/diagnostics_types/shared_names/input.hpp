#pragma once
namespace bad {
struct Robot {
    struct arm {
        double length;
    } arm;
    enum mode { off, on } mode;
    int fine;
};
struct state {
    int x;
};
int state(const struct state& of);
struct Fine {
    typedef struct {
        int x;
    } part;
    part part_;
};
}
// As in <sys/time.h>, without <time.h>, which has a variable of that name.
struct timezone { int minutes; };
