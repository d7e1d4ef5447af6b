// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Numbers of types that instructions do not compute with, as structs have them: they behave as the wider ones.
#include "script_fixture.hpp"

#include <cstdint>

using namespace RTT;

namespace {

class SmallNumbers : public ScriptTest {
protected:
    SmallNumbers() {
        component.addAttribute("tiny", tiny);
        component.addAttribute("byte", byte);
        component.addAttribute("word", word);
        component.addAttribute("count", count);
        component.addAttribute("size", size);
        component.addAttribute("n", n);
        component.addAttribute("v", v);
    }

    std::int8_t tiny = -3;
    std::uint8_t byte = 200;
    std::uint16_t word = 60000;
    std::int64_t count = 5000000000;
    std::uint64_t size = 18000000000000000000u;
    int n = 4;
    std::vector<double> v{1, 2, 3};
};

}  // namespace

TEST_F(SmallNumbers, AreComputedWith) {
    EXPECT_EQ(result<int>("int", "tiny + n"), 1);
    EXPECT_EQ(result<int>("int", "n * byte"), 800);
    EXPECT_EQ(result<int>("int", "byte + byte"), 400);
    EXPECT_EQ(result<int>("int", "-word"), -60000);
    EXPECT_EQ(result<long long>("llong", "count * 2"), 10000000000);
    EXPECT_EQ(result<unsigned long long>("ullong", "size - size"), 0u);
    EXPECT_EQ(result<double>("double", "count / 2.0"), 2500000000.0);
}

TEST_F(SmallNumbers, AreCompared) {
    EXPECT_TRUE(result<bool>("bool", "tiny < 0"));
    EXPECT_TRUE(result<bool>("bool", "count == count"));
    EXPECT_FALSE(result<bool>("bool", "word > 60000"));
    ASSERT_TRUE(run("if byte then n = 7")) << messages();
    EXPECT_EQ(n, 7);
}

TEST_F(SmallNumbers, AreAssignedWhatFits) {
    ASSERT_TRUE(run("tiny = tiny + 1\ncount = count + n\nword = 2 * 300\nn = byte")) << messages();
    EXPECT_EQ(tiny, -2);
    EXPECT_EQ(count, 5000000004);
    EXPECT_EQ(word, 600);
    EXPECT_EQ(n, 200);
    ASSERT_TRUE(run("count = tiny\nsize = word\nvar int64 c = 3\nc = c + c")) << messages();
    EXPECT_EQ(count, -2);
    EXPECT_EQ(size, 600u);
    EXPECT_FALSE(run("tiny = 300"));
    EXPECT_EQ(tiny, -2);
}

TEST_F(SmallNumbers, SelectElements) {
    ASSERT_TRUE(run("byte = 2\nv[byte] = 8")) << messages();
    EXPECT_EQ(v[2], 8);
}
