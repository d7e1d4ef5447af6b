#pragma once
namespace library {
class Matrix {
    double* storage_ = nullptr;
    int rows_ = 0;
};
struct Frame { Matrix rotation; };
}
