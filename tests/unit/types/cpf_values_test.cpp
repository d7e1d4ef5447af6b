// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The values of property files: every value is read back as it was, and files of the original read as they did there.
#include "cpf_fixture.hpp"

#include <cpf/cpf_reader.hpp>
#include <cpf/cpf_writer.hpp>

#include <cmath>
#include <cstring>
#include <limits>

using namespace RTT;
using namespace RTT::marsh;
using namespace types_test;

namespace {

class CpfValues : public Cpf {
protected:
    /** The value after it was written and read. */
    template <class T>
    T back(const T& value) {
        PropertyBag out, in;
        out.ownProperty(new Property<T>("p", "", value));
        const std::string text = cpfText(out);
        EXPECT_TRUE(readText(text, "f", in, sink)) << text;
        const auto* property = in.getPropertyType<T>("p");
        EXPECT_NE(nullptr, property) << text;
        if (property) {
            EXPECT_EQ(text, cpfText(in));
        }
        return property ? property->get() : T();
    }
    template <class T>
    void expectBack(std::initializer_list<T> values) {
        for (const T& value : values) {
            const T read = back(value);
            EXPECT_EQ(0, std::memcmp(&value, &read, sizeof value)) << value << " became " << read;
        }
    }
    /** The value of a file written by hand. */
    template <class T>
    T valueOf(const std::string& type, const std::string& text) {
        put(simple(type, text));
        PropertyBag in;
        EXPECT_TRUE(readFile(file, in, sink)) << said();
        const auto* property = in.getPropertyType<T>("p");
        EXPECT_NE(nullptr, property);
        return property ? property->get() : T();
    }
    bool isRead(const std::string& type, const std::string& text) {
        put(simple(type, text));
        PropertyBag in;
        return readFile(file, in, sink);
    }
};

template <class T>
constexpr T lowest = std::numeric_limits<T>::lowest();
template <class T>
constexpr T highest = std::numeric_limits<T>::max();

}  // namespace

TEST_F(CpfValues, RealNumbersAreExact) {
    using D = std::numeric_limits<double>;
    using F = std::numeric_limits<float>;
    expectBack<double>({0.0, -0.0, 0.1, 1.0 / 3, 1e300, 5e-324, 2.2250738585072011e-308, D::min(), D::max(),
                        D::lowest(), D::epsilon(), D::infinity(), -D::infinity(), 9007199254740993.0});
    expectBack<float>({0.0f, -0.0f, 0.1f, 1.0f / 3, 1e-45f, F::min(), F::max(), F::lowest(), F::infinity(),
                       -F::infinity(), 16777217.0f});
    EXPECT_TRUE(std::isnan(back(D::quiet_NaN())));
    EXPECT_TRUE(std::isnan(back(F::quiet_NaN())));
}

TEST_F(CpfValues, ManyRealNumbersAreExact) {
    std::uint64_t bits = 0x9E3779B97F4A7C15u;
    for (int i = 0; i != 2000; ++i) {
        bits ^= bits << 13;
        bits ^= bits >> 7;
        bits ^= bits << 17;
        double value;
        std::memcpy(&value, &bits, sizeof value);
        if (!std::isnan(value)) expectBack<double>({value});
    }
}

TEST_F(CpfValues, WholeNumbersAreExact) {
    expectBack<int>({0, -1, lowest<int>, highest<int>});
    expectBack<unsigned int>({0, 1, highest<unsigned int>});
    expectBack<long long>({0, lowest<long long>, highest<long long>});
    expectBack<unsigned long long>({0, highest<unsigned long long>});
    EXPECT_TRUE(back(true));
    EXPECT_FALSE(back(false));
}

TEST_F(CpfValues, EveryCharacterIsExact) {
    for (int c = -128; c != 128; ++c) EXPECT_EQ(c, back(static_cast<char>(c)));
    for (int c = 0; c != 256; ++c) EXPECT_EQ(c, back(static_cast<unsigned char>(c)));
}

TEST_F(CpfValues, EveryTextIsExact) {
    std::string all;
    for (int c = 0; c != 128; ++c) all += static_cast<char>(c);
    for (const std::string& text :
         {std::string(), std::string(" "), std::string("  "), std::string(" a  b "), std::string("\n"),
          std::string("one\n two\r\n\tthree\n"), std::string("a &amp; <b> ]]> \"c\" 'd'"), std::string("&#32;"),
          std::string("\xC3\xA4 \xE2\x82\xAC \xF0\x9F\x98\x80"), std::string("<!-- no comment -->"), all}) {
        EXPECT_EQ(text, back(text));
    }
}

TEST_F(CpfValues, NamesAndDescriptionsAreExact) {
    PropertyBag out, in;
    out.ownProperty(new Property<int>(" a \"b\"\n<c>&'", "two\n  lines \t", 1));
    ASSERT_TRUE(readText(cpfText(out), "f", in, sink)) << said();
    EXPECT_EQ(out.getItem(0)->getName(), in.getItem(0)->getName());
    EXPECT_EQ(out.getItem(0)->getDescription(), in.getItem(0)->getDescription());
}

TEST_F(CpfValues, BlanksThatAreNotWrittenAsReferencesAreCondensed) {
    EXPECT_EQ("a b c", valueOf<std::string>("string", "\n   a\n  b\t c  "));
    EXPECT_EQ(" a  b ", valueOf<std::string>("string", " <![CDATA[ a  b ]]> "));
    EXPECT_EQ(" x", valueOf<std::string>("string", " &#x20;x "));
    EXPECT_EQ("ab", valueOf<std::string>("string", "a<!-- between -->b"));
    EXPECT_EQ("1 & 2 &unknown; &#xZ;", valueOf<std::string>("string", "1 & 2 &unknown; &#xZ;"));
    EXPECT_EQ("\xE2\x82\xAC", valueOf<std::string>("string", "&#8364;"));
    EXPECT_EQ('\0', valueOf<char>("char", " "));
}

TEST_F(CpfValues, FilesOfTheOriginalAreRead) {
    EXPECT_EQ(0.1, valueOf<double>("double", "0.1000000000000000055511151"));
    EXPECT_EQ(5e-324, valueOf<double>("double", "4.940656458412465441765688e-324"));
    EXPECT_EQ(0.1f, valueOf<float>("float", "0.100000001490116"));
    EXPECT_EQ(highest<float>, valueOf<float>("float", "3.40282346638529e+38"));
    EXPECT_TRUE(std::isinf(valueOf<double>("double", "-inf")));
    EXPECT_TRUE(std::isnan(valueOf<double>("double", "-nan")));
    EXPECT_EQ(0.0, valueOf<double>("double", "1e-400")) << "too small";
    EXPECT_EQ(0.0f, valueOf<float>("float", "1e-60"));
    EXPECT_EQ(8.0, valueOf<double>("double", "0x1p3"));
    EXPECT_EQ(-1.5, valueOf<double>("double", "-0X1.8"));
    EXPECT_EQ(5.0, valueOf<double>("double", "+5"));
    EXPECT_EQ(-3, valueOf<int>("short", "-3"));
    EXPECT_EQ(3u, valueOf<unsigned int>("ushort", "3"));
    EXPECT_EQ('y', valueOf<unsigned char>("uchar", "y"));
    EXPECT_TRUE(valueOf<bool>("boolean", "1"));
    EXPECT_FALSE(valueOf<bool>("boolean", " false "));
    EXPECT_TRUE(sink.empty()) << said();
}

TEST_F(CpfValues, WrongValuesAreRefused) {
    for (const char* text : {"True", "yes", "2", ""}) EXPECT_FALSE(isRead("boolean", text)) << text;
    for (const char* text : {"", "x", "+-5", "--5", "1e400"}) EXPECT_FALSE(isRead("double", text)) << text;
    for (const char* text : {"", "x", "+-5", "2147483648"}) EXPECT_FALSE(isRead("long", text)) << text;
    EXPECT_FALSE(isRead("ulong", "-1"));
    EXPECT_FALSE(isRead("char", "ab"));
    EXPECT_FALSE(isRead("objref", "x"));
}
