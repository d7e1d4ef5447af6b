#pragma once
namespace bad {
struct Fixed {
    const int size = 3;
    volatile int flag = 0;
};
}
