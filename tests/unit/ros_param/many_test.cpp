// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Many parameters take few calls of the master.
#include "param_fixture.hpp"

#include <chrono>
#include <list>

namespace param_test {

class ManyParameters : public WithMaster {};

/** Milliseconds. */
template <class Function>
double timeOf(Function function) {
    const auto begin = std::chrono::steady_clock::now();
    function();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

TEST_F(ManyParameters, AThousand) {
    std::list<int> values;
    for (int i = 0; i != 1000; ++i) {
        values.push_back(i);
        component_.provides("s" + std::to_string(i % 10))->addProperty("p" + std::to_string(i), values.back());
    }
    const double setting = timeOf([&] { EXPECT_TRUE(call(component_, "setAll")) << log_.take(); });
    for (int& value : values) value = -1;
    const double getting = timeOf([&] { EXPECT_TRUE(call(component_, "getAll")) << log_.take(); });
    int expected = 0;
    for (const int value : values) EXPECT_EQ(expected++, value);
    const double single = timeOf([&] {
        for (int i = 0; i != 20; ++i) ros::param::set("/n/c/single", i);
    });
    RecordProperty("set_ms", std::to_string(setting));
    RecordProperty("get_ms", std::to_string(getting));
    std::cout << "1000 parameters: set " << setting << " ms, get " << getting << " ms; 20 calls: " << single << " ms\n";
    // One call per parameter would take 50 times as long as 20.
    EXPECT_LT(getting, 25 * single);
}

TEST_F(ManyParameters, ALongArray) {
    std::vector<double> values(20000);
    for (std::size_t i = 0; i != values.size(); ++i) values[i] = static_cast<double>(i) / 3;
    const std::vector<double> before = values;
    component_.addProperty("p", values);
    const double setting = timeOf([&] { EXPECT_TRUE(call(component_, "setAll")) << log_.take(); });
    values.clear();
    const double getting = timeOf([&] { EXPECT_TRUE(call(component_, "getAll")) << log_.take(); });
    EXPECT_EQ(before, values);
    std::cout << "array of 20000: set " << setting << " ms, get " << getting << " ms\n";
}

}  // namespace param_test
