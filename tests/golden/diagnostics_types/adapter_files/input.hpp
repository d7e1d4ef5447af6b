#pragma once
struct Plain {
    int x = 0;
};
