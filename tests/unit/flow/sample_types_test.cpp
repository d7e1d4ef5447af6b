// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Ports of C++ types that no typekit knows: whatever can be default constructed and assigned.
#include <rtt/Port.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

using namespace RTT;

namespace {

struct NoComparison {
    int a = 0;
    std::map<std::string, int> table;
};
struct Large {
    unsigned char bytes[1 << 20];
};
struct alignas(256) Wide {
    double number = 0;
    /** Zero if the object lies where its type wants it. */
    std::uintptr_t misplaced() const { return reinterpret_cast<std::uintptr_t>(this) % 256; }
};
enum class Mode { idle, fast };

/** Assigning a negative one throws. */
struct Thrower {
    Thrower() { ++alive; }
    explicit Thrower(int v) : value(v) { ++alive; }
    Thrower(const Thrower& o) : value(o.value) {
        check();
        ++alive;
    }
    Thrower& operator=(const Thrower& o) {
        o.check();
        value = o.value;
        return *this;
    }
    ~Thrower() { --alive; }
    void check() const {
        if (value < 0) throw std::runtime_error("not assignable");
    }
    int value = 0;
    static int alive;
};
int Thrower::alive = 0;

/** A container of itself, as types of JSON libraries are. */
struct Json {
    typedef Json value_type;
    int number = 0;
    std::string text;
    std::size_t size() const { return 1; }
    const Json* begin() const { return this; }
    const Json* end() const { return this + 1; }
};
/** What size() is, nobody knows. */
struct Image {
    struct Size {
        int width, height;
    };
    typedef std::string value_type;
    std::string pixels;
    Size size() const { return {1, 1}; }
    const char* begin() const { return pixels.data(); }
    const char* end() const { return begin() + pixels.size(); }
};
/** Hides the usual forms of new. */
struct Pooled {
    void* operator new(std::size_t size) { return ::operator new(size); }
    void operator delete(void* at) { ::operator delete(at); }
    std::string text;
};

std::vector<ConnPolicy> everyStorage() {
    std::vector<ConnPolicy> all;
    for (const int lock : {ConnPolicy::UNSYNC, ConnPolicy::LOCKED, ConnPolicy::LOCK_FREE}) {
        all.push_back(ConnPolicy::data(lock));
        all.push_back(ConnPolicy::buffer(2, lock));
        all.push_back(ConnPolicy::circularBuffer(2, lock));
    }
    return all;
}

/** Brings `sent` over every storage and lets `same` look at what arrived. */
template <class T>
void expectCarried(const T& sent, const std::function<bool(const T&)>& same) {
    for (const ConnPolicy& policy : everyStorage()) {
        OutputPort<T> out("out");
        InputPort<T> in("in");
        ASSERT_TRUE(out.createConnection(in, policy));
        const std::unique_ptr<T> got(new T());
        EXPECT_EQ(in.read(*got), NoData);
        ASSERT_EQ(out.write(sent), WriteSuccess) << policy;
        ASSERT_EQ(in.read(*got), NewData) << policy;
        EXPECT_TRUE(same(*got)) << policy;
        EXPECT_EQ(in.read(*got), OldData) << policy;
        EXPECT_TRUE(same(*got)) << policy;
    }
}

}  // namespace

TEST(SampleTypes, NeedNoComparison) {
    NoComparison sent;
    sent.a = 3;
    sent.table["x"] = 4;
    expectCarried<NoComparison>(sent, [](const NoComparison& got) { return got.a == 3 && got.table.at("x") == 4; });
}

TEST(SampleTypes, MayLookLikeContainersAndBeNone) {
    Json number;
    number.text = "five";
    expectCarried<Json>(number, [](const Json& got) { return got.text == "five"; });
    Image image;
    image.pixels = "pixels";
    expectCarried<Image>(image, [](const Image& got) { return got.pixels == "pixels"; });
}

TEST(SampleTypes, MayHaveTheirOwnNew) {
    Pooled sent;
    sent.text = "pooled";
    expectCarried<Pooled>(sent, [](const Pooled& got) { return got.text == "pooled"; });
}

TEST(SampleTypes, MayBeLarge) {
    const std::unique_ptr<Large> sent(new Large());
    sent->bytes[0] = 1;
    sent->bytes[sizeof(Large) - 1] = 2;
    expectCarried<Large>(*sent,
                         [](const Large& got) { return got.bytes[0] == 1 && got.bytes[sizeof(Large) - 1] == 2; });
}

TEST(SampleTypes, MayBeAlignedWidely) {
    Wide sent;
    sent.number = 1.5;
    expectCarried<Wide>(sent, [](const Wide& got) { return got.number == 1.5 && got.misplaced() == 0; });
}

TEST(SampleTypes, MayBeEnumsBoolsPointersAndSmartPointers) {
    expectCarried<Mode>(Mode::fast, [](Mode got) { return got == Mode::fast; });
    expectCarried<bool>(true, [](bool got) { return got; });
    static int target;
    expectCarried<int*>(&target, [](int* got) { return got == &target; });
    const std::shared_ptr<const std::string> text = std::make_shared<const std::string>("shared");
    expectCarried<std::shared_ptr<const std::string>>(
        text, [&](const std::shared_ptr<const std::string>& got) { return got == text; });
}

TEST(SampleTypes, MayThrowWhenAssignedAndThenNothingIsLostOrBroken) {
    const int before = Thrower::alive;
    for (const ConnPolicy& policy : everyStorage()) {
        OutputPort<Thrower> out("out");
        InputPort<Thrower> in("in");
        ASSERT_TRUE(out.createConnection(in, policy));
        Thrower bad, got;
        bad.value = -1;
        ASSERT_EQ(out.write(Thrower(1)), WriteSuccess);
        for (int i = 0; i < 50; ++i) EXPECT_THROW((void)out.write(bad), std::runtime_error) << policy;
        EXPECT_EQ(in.read(got), NewData) << policy;
        EXPECT_EQ(got.value, 1) << policy;
        EXPECT_EQ(out.write(Thrower(2)), WriteSuccess) << policy;
        EXPECT_EQ(in.read(got), NewData) << policy;
        EXPECT_EQ(got.value, 2) << policy;
        EXPECT_EQ(out.getLastWrittenValue().value, 2);
        EXPECT_THROW(out.setDataSample(bad), std::runtime_error);
        InputPort<Thrower> second("second");
        EXPECT_TRUE(out.createConnection(second, policy));
    }
    EXPECT_EQ(Thrower::alive, before);
}
