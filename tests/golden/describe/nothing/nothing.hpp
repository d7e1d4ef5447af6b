#pragma once
struct Plain {
    int value;
};
