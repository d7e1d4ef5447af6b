// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Bytes of values, written out by hand from the rules of CDR.
#include "encoded_types.hpp"

#include <atomic>
#include <cstdlib>
#include <new>
#include <set>

using namespace RTT::encoding;
using encoded::EncodedTypes;
namespace t = RTT::types;
using encoded::Mixed;
using encoded::Nothing;
using encoded::Tree;
using sample::Point;
using sample::Tank;

namespace {

std::atomic<long> allocations{0};

/** "01 02" as two bytes. */
std::string hex(const std::string& digits) {
    std::string bytes;
    for (std::size_t i = 0; i < digits.size(); i += 3)
        bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
    return bytes;
}

Tank fullTank() {
    Tank tank;
    tank.id = 3;
    tank.label = "main";
    tank.position = {1, 2};
    tank.levels = {0.5, 0.25};
    tank.path = {{1, 2}, {3, 4}};
    tank.weights[1] = 7;
    tank.pair = {{4, 5}};
    tank.mode = sample::Mode::Draining;
    tank.small = 9;
    tank.flags = {true, false, true};
    return tank;
}

}  // namespace

[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* const memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

TEST_F(EncodedTypes, NumbersBeginAtMultiplesOfTheirSize) {
    const Mixed mixed{true, 2, 1.0F, 1.0, 'A'};
    EXPECT_EQ(bytesOf(mixed), hex("01 00 02 00 00 00 80 3f 00 00 00 00 00 00 f0 3f 41"));
    EXPECT_EQ(planOf<Mixed>()->fixedSize(), 17U);
}

TEST_F(EncodedTypes, WithoutAlignmentTheyFollowEachOther) {
    const Mixed mixed{true, 2, 1.0F, 1.0, 'A'};
    EXPECT_EQ(bytesOf(mixed, ros1Rules()), hex("01 02 00 00 00 80 3f 00 00 00 00 00 00 f0 3f 41"));
}

TEST_F(EncodedTypes, ElementsAreAlignedFromTheFirstByte) {
    const std::vector<Mixed> two{{true, 2, 1.0F, 1.0, 'A'}, {false, 3, 2.0F, 2.0, 'B'}};
    EXPECT_EQ(bytesOf(two), hex("02 00 00 00 01 00 02 00 00 00 80 3f 00 00 00 00 00 00 00 00 00 00 f0 3f 41 "
                                "00 03 00 00 00 00 40 00 00 00 00 00 00 00 40 42"));
}

TEST_F(EncodedTypes, TextsEndWithAZeroByte) {
    EXPECT_EQ(bytesOf(std::string("ab")), hex("03 00 00 00 61 62 00"));
    EXPECT_EQ(bytesOf(std::string("ab"), ros1Rules()), hex("02 00 00 00 61 62"));
    EXPECT_EQ(bytesOf(std::string("a\0b", 3)), hex("04 00 00 00 61 00 62 00"));
}

TEST_F(EncodedTypes, EnumeratorsAreTheirValueOrTheirRankAmongTheNames) {
    EXPECT_EQ(bytesOf(sample::Mode::Draining), hex("07"));
    EXPECT_EQ(bytesOf(sample::Mode::Draining, corbaRules()), hex("00 00 00 00"));
    EXPECT_EQ(bytesOf(sample::Mode::Idle, corbaRules()).substr(1), hex("00 00 00"));
    sample::Mode mode{};
    const std::string idle = bytesOf(sample::Mode::Idle, corbaRules());
    EXPECT_FALSE(decode(idle, mode, ByteOrder::Little, corbaRules()));
    EXPECT_EQ(mode, sample::Mode::Idle);
    EXPECT_FALSE(decode(hex("00 00 00 00"), mode, ByteOrder::Big, corbaRules()));
    EXPECT_EQ(mode, sample::Mode::Draining);
    const auto unnamed = static_cast<sample::Mode>(99);
    EXPECT_EQ(planOf<sample::Mode>(corbaRules())->sizeOf(&unnamed), 0U);
}

TEST_F(EncodedTypes, TextsMayEndAtTheirFirstZero) {
    EXPECT_EQ(bytesOf(std::string("a\0b", 3), corbaRules()), hex("02 00 00 00 61 00"));
}

TEST_F(EncodedTypes, AStructWithoutFieldsHasOneByte) {
    EXPECT_EQ(bytesOf(Nothing()), hex("00"));
    Nothing nothing;
    EXPECT_FALSE(decode(hex("00"), nothing));
    EXPECT_TRUE(decode("", nothing));
}

TEST_F(EncodedTypes, ValuesComeBackFromBothOrders) {
    Mixed mixed;
    EXPECT_FALSE(decode(hex("01 00 00 02 3f 80 00 00 3f f0 00 00 00 00 00 00 41"), mixed, ByteOrder::Big));
    EXPECT_TRUE(mixed.on && mixed.step == 2 && mixed.gain == 1 && mixed.sum == 1 && mixed.letter == 'A');
    Tank tank;
    EXPECT_FALSE(decode(bytesOf(fullTank()), tank));
    EXPECT_EQ(jsonOf<Tank>()->text(&tank), jsonOf<Tank>()->text(std::addressof(static_cast<const Tank&>(fullTank()))));
}

TEST_F(EncodedTypes, DecodingReplacesEarlierContents) {
    Tank tank = fullTank();
    EXPECT_FALSE(decode(bytesOf(Tank()), tank));
    EXPECT_TRUE(tank.levels.empty() && tank.label.empty() && tank.flags.empty() && tank.weights[1] == 0);
}

TEST_F(EncodedTypes, WrongBytesAreNamed) {
    std::string text;
    EXPECT_EQ(decode(hex("03 00 00 00 61 62 63"), text).text(), "byte 4: a text does not end with a zero byte");
    EXPECT_EQ(decode(hex("ff ff ff ff 61 62 63"), text).text(),
              "byte 4: a text is longer than the bytes that are left");
    Mixed mixed;
    EXPECT_EQ(decode(hex("02"), mixed).text(), "byte 0: a bool is neither 0 nor 1");
    EXPECT_EQ(decode(hex("01 00 02"), mixed).text(), "byte 2: the bytes end within the value");
    std::vector<Mixed> many;
    EXPECT_EQ(decode(hex("00 00 00 40 01 02"), many).text(),
              "byte 4: a container has more elements than there are bytes for");
    EXPECT_TRUE(many.empty()) << "memory was taken for elements that are not there";
    EXPECT_EQ(decode(hex("00 00 00 00 01"), many).text(), "byte 4: there are bytes behind the value");
}

TEST_F(EncodedTypes, ValuesNestToALimit) {
    Tree tree;
    Tree* leaf = &tree;
    for (unsigned depth = 1; depth != Plan::kDeepest; ++depth) {
        leaf->branches.emplace_back();
        leaf = &leaf->branches[0];
    }
    const std::string bytes = bytesOf(tree);
    EXPECT_NE(bytes, "");
    Tree back;
    EXPECT_FALSE(decode(bytes, back));
    EXPECT_EQ(bytesOf(back), bytes);
    leaf->branches.emplace_back();
    EXPECT_EQ(planOf<Tree>()->sizeOf(&tree), 0U);
    std::string deep;
    for (int i = 0; i != 100; ++i) deep += hex("00 00 00 00 01 00 00 00");
    EXPECT_EQ(decode(deep, back).text(), "byte 516: the value nests too deeply");
}

TEST_F(EncodedTypes, NumbersThatAnEnumerationCannotHaveAreRefused) {
    sample::Mode mode{};
    EXPECT_EQ(decode(hex("01 01 00 00"), mode, ByteOrder::Little, corbaRules()).text(),
              "byte 4: an enumeration has fewer names");
    encoded::Switch onOff{};
    EXPECT_TRUE(decode(hex("02"), onOff));
    EXPECT_FALSE(decode(hex("01"), onOff));
}

TEST_F(EncodedTypes, AMatrixTakesMemoryOnlyForRowsThatAreThere) {
    encoded::Matrix matrix;
    const std::string row = hex("02 00 00 00 01 00 00 00 02 00 00 00");
    EXPECT_FALSE(decode(hex("02 00 00 00") + row + row, matrix));
    EXPECT_EQ(matrix.columns, 2U);
    EXPECT_EQ(matrix.numbers, (std::vector<int>{1, 2, 1, 2}));
    EXPECT_EQ(bytesOf(matrix), hex("02 00 00 00") + row + row);
    EXPECT_EQ(decode(hex("06 00 00 00") + row + row, matrix).text(),
              "byte 16: a matrix has more rows than there are bytes for");
    EXPECT_EQ(decode(hex("03 00 00 00") + row + hex("00 00 00 00 00 00 00 00 00 00 00 00"), matrix).text(),
              "byte 20: the rows of a matrix have different lengths");
    EXPECT_LT(matrix.numbers.size(), 10U);
    EXPECT_EQ(jsonOf<encoded::Matrix>()->parse("[[1, 2, 3], [4]]", &matrix), "the rows have different lengths");
    EXPECT_EQ(jsonOf<encoded::Matrix>()->parse("[[1, 2, 3], [4, 5, 6]]", &matrix), "");
    EXPECT_EQ(jsonOf<encoded::Matrix>()->text(&matrix), "[[1,2,3],[4,5,6]]");
}

TEST_F(EncodedTypes, AnExceptionOfTheTypeIsAnError) {
    encoded::Picky picky;
    EXPECT_EQ(decode(hex("01 00 00 00"), picky).text(), "");
    EXPECT_EQ(decode(hex("ff ff ff ff"), picky).text(), "byte 4: the type refuses the value with an exception");
    EXPECT_EQ(jsonOf<encoded::Picky>()->parse(R"({"level": -1})", &picky), "the type refuses the value: below 0");
}

TEST_F(EncodedTypes, LongListsTakeLinearTime) {
    const std::list<int> values(200000, 3);
    const std::string bytes = bytesOf(values);
    std::list<int> back;
    EXPECT_FALSE(decode(bytes, back));
    EXPECT_EQ(back, values);
    EXPECT_EQ(jsonOf<std::list<int>>()->parse(jsonOf<std::list<int>>()->text(&values), &back), "");
}

TEST_F(EncodedTypes, AlternativesOfUnknownTypesAreRefused) {
    std::string why;
    EXPECT_FALSE(Plan::make(*t::Types()->getTypeInfo<encoded::Choice>(), cdrRules(), why));
    EXPECT_EQ(why, ".unknown: no typekit that is loaded has the type encoded::Unknown");
}

TEST_F(EncodedTypes, TypesWithoutAShapeAreRefused) {
    std::string why;
    EXPECT_FALSE(Plan::make(*types_test::type("PropertyBag"), cdrRules(), why));
    EXPECT_EQ(why, "the type PropertyBag has no shape: its typekit does not say what it consists of");
}

TEST_F(EncodedTypes, NeitherWayAllocatesOnceContainersAreLargeEnough) {
    const auto plan = planOf<Tank>();
    const Tank from = fullTank();
    Tank to = from;
    char bytes[1000];
    const long before = allocations;
    const std::size_t size = plan->encode(&from, bytes, sizeof bytes);
    const bool isDecoded = !plan->decode(bytes, size, kNativeOrder, &to);
    EXPECT_EQ(allocations, before);
    EXPECT_TRUE(isDecoded && size != 0);
}

TEST_F(EncodedTypes, FingerprintsTellTypesApart) {
    EXPECT_EQ(planOf<Tank>()->fingerprint(), planOf<Tank>()->fingerprint());
    EXPECT_EQ(planOf<std::vector<int>>()->fingerprint(), planOf<std::list<int>>()->fingerprint()) << "equal bytes";
    const std::set<std::uint64_t> all{planOf<Mixed>()->fingerprint(),
                                      planOf<Tree>()->fingerprint(),
                                      planOf<Tank>()->fingerprint(),
                                      planOf<Point>()->fingerprint(),
                                      planOf<int>()->fingerprint(),
                                      planOf<unsigned>()->fingerprint(),
                                      planOf<float>()->fingerprint(),
                                      planOf<std::string>()->fingerprint(),
                                      planOf<std::vector<int>>()->fingerprint(),
                                      planOf<std::vector<Point>>()->fingerprint(),
                                      planOf<sample::Mode>()->fingerprint(),
                                      planOf<encoded::Switch>()->fingerprint()};
    EXPECT_EQ(all.size(), 12U);
}
