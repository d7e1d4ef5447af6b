#pragma once
#include <memory>
// Cases 06, 15, 31 and 37 of the type matrix.
namespace bad {
struct Wrong {
    [[oro::capacity(20)]] int number;
    [[oro::text]] int digits[3];
    [[oro::bytes]] double value;
    [[oro::by_value]] std::weak_ptr<int> other;
    [[oro::by_value]] std::shared_ptr<int[]> list;
    std::unique_ptr<int> own;  ///< @by_value
};
}
