// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/lexer.hpp>

#include <gtest/gtest.h>

#include <string>

namespace {

using RTT::scripting::detail::Lexer;
using RTT::scripting::detail::Token;
using RTT::scripting::detail::TokenKind;

/// The tokens, each with its kind if that is not obvious: w(ord), t(ype), n(umber), s(tring), l(etter), ?(stray), !(open).
/// '/' stands before the first of each line.
std::string tokens(const std::string& text) {
    Lexer lexer(text);
    std::string result;
    for (Token token = lexer.next();; token = lexer.next()) {
        if (token.newLine) result += "/ ";
        if (token.kind == TokenKind::End) return result + "end";
        const char* kind = "";
        switch (token.kind) {
            case TokenKind::Word: kind = "w:"; break;
            case TokenKind::TypeWord: kind = "t:"; break;
            case TokenKind::Number: kind = "n:"; break;
            case TokenKind::Text: kind = "s:"; break;
            case TokenKind::Letter: kind = "l:"; break;
            case TokenKind::Stray: kind = "?:"; break;
            case TokenKind::OpenText:
            case TokenKind::OpenComment: kind = "!:"; break;
            default: break;
        }
        result += kind + std::string(lexer.text(token)) + " ";
    }
}

TEST(Lexer, NothingIsTheEnd) {
    EXPECT_EQ(tokens(""), "/ end");
    EXPECT_EQ(tokens(" \t\r"), "/ end");
    EXPECT_EQ(tokens("\n\n"), "/ end");
}

TEST(Lexer, WordsBeginWithALetterOrUnderscore) {
    EXPECT_EQ(tokens("a B2 _c d_e"), "/ w:a w:B2 w:_c w:d_e end");
    EXPECT_EQ(tokens("2b"), "/ n:2b end");
}

TEST(Lexer, SignsOfTwoLettersComeFirst) {
    EXPECT_EQ(tokens("&&||!===<=>=::"), "/ && || != == <= >= :: end");
    EXPECT_EQ(tokens("! = < = : :"), "/ ! = < = : : end");
    EXPECT_EQ(tokens("(){}[],;.:=+-*/%!<>"), "/ ( ) { } [ ] , ; . : = + - * / % ! < > end");
}

TEST(Lexer, NumbersTakeTheirSuffixWithThem) {
    EXPECT_EQ(tokens("1 1.5 1. .5 0x1F 12ull 10ms 1.5f 2e3 2E-3 1.e+5"),
              "/ n:1 n:1.5 n:1. n:.5 n:0x1F n:12ull n:10ms n:1.5f n:2e3 n:2E-3 n:1.e+5 end");
    EXPECT_EQ(tokens("1+2 3-4 1e+ 0xe+1"), "/ n:1 + n:2 n:3 - n:4 n:1e + n:0xe + n:1 end");
    EXPECT_EQ(tokens("v[0].x"), "/ w:v [ n:0 ] . w:x end");
}

TEST(Lexer, TextsKeepEscapedQuotes) {
    EXPECT_EQ(tokens(R"("a" "b\"c" "\\" 'd' '\'' "")"), R"(/ s:"a" s:"b\"c" s:"\\" l:'d' l:'\'' s:"" end)");
    EXPECT_EQ(tokens("\"# // /*\""), "/ s:\"# // /*\" end");
}

TEST(Lexer, TextsEndOnTheirLine) {
    EXPECT_EQ(tokens("\"abc\nd\""), "/ !:\"abc / w:d !:\" end");
    EXPECT_EQ(tokens("'a"), "/ !:'a end");
    EXPECT_EQ(tokens("\"a\\\nb"), "/ !:\"a\\ / w:b end");
    EXPECT_EQ(tokens("\"a\\"), "/ !:\"a\\ end");
}

TEST(Lexer, CommentsAreBlanks) {
    EXPECT_EQ(tokens("a # b\nc // d\n/* e */ f/**/g"), "/ w:a / w:c / w:f w:g end");
    EXPECT_EQ(tokens("###### a\n//////\n/***/b"), "/ w:b end");
    EXPECT_EQ(tokens("a /* b /* c */ d */"), "/ w:a w:d * / end");
    EXPECT_EQ(tokens("# \xD0\xBF\xD1\x80\n/* \xC3\xA9 */ a"), "/ w:a end");
}

TEST(Lexer, CommentsOfSeveralLinesHaveNewlines) { EXPECT_EQ(tokens("a /* b\nc */ d e"), "/ w:a / w:d w:e end"); }

TEST(Lexer, CommentsThatDoNotEndReachToTheEnd) {
    EXPECT_EQ(tokens("a /* b\nc"), "/ w:a !:/* b\nc end");
    EXPECT_EQ(tokens("/*/"), "/ !:/*/ end");
}

TEST(Lexer, BytesThatMeanNothingAreStray) {
    EXPECT_EQ(tokens("a $ & | \\ @"), "/ w:a ?:$ ?:& ?:| ?:\\ ?:@ end");
    EXPECT_EQ(tokens(std::string("a\0b", 3)), std::string("/ w:a ?:\0 w:b end", 17));
    EXPECT_EQ(tokens("a \xC3\xA9\xC3\xA8 b"), "/ w:a ?:\xC3\xA9\xC3\xA8 w:b end");
}

TEST(Lexer, NamesOfTypesThatCanBeCalledAreOneWord) {
    EXPECT_EQ(tokens("ints[](1)"), "/ t:ints[] ( n:1 ) end");
    EXPECT_EQ(tokens("vector<double>(3)"), "/ t:vector<double> ( n:3 ) end");
    EXPECT_EQ(tokens("a.b<c<d>>(1)"), "/ w:a . t:b<c<d>> ( n:1 ) end");
    EXPECT_EQ(tokens("map</std/string,int>[](1)"), "/ t:map</std/string,int>[] ( n:1 ) end");
}

TEST(Lexer, ComparisonsAreNoTypes) {
    EXPECT_EQ(tokens("a<b>c"), "/ w:a < w:b > w:c end");
    EXPECT_EQ(tokens("a < b>(c)"), "/ w:a < w:b > ( w:c ) end");
    EXPECT_EQ(tokens("a<b && c>(d)"), "/ w:a < w:b && w:c > ( w:d ) end");
    EXPECT_EQ(tokens("a<1>(d)"), "/ w:a < n:1 > ( w:d ) end");
    EXPECT_EQ(tokens("a<b//>(d)"), "/ w:a < w:b end");
    EXPECT_EQ(tokens("a [] a[ ]"), "/ w:a [ ] w:a [ ] end");
}

TEST(Lexer, ByteOrderMarkIsSkipped) {
    EXPECT_EQ(tokens("\xEF\xBB\xBF"
                     "a"),
              "/ w:a end");
}

TEST(Lexer, LineEndsOfWindowsAreLineEnds) { EXPECT_EQ(tokens("a # b\r\nc\r\n"), "/ w:a / w:c / end"); }

TEST(Lexer, TokensKnowWhereTheyAre) {
    const std::string text = "a\n\t/* \n */ \xC3\xA9 bc\n";
    Lexer lexer(text);
    const auto expect = [&](unsigned line, unsigned column, std::size_t begin, std::size_t end) {
        const Token token = lexer.next();
        EXPECT_EQ(token.line, line);
        EXPECT_EQ(token.column, column);
        EXPECT_EQ(token.begin, begin);
        EXPECT_EQ(token.end, end);
    };
    expect(1, 1, 0, 1);
    expect(3, 5, 11, 13);
    expect(3, 8, 14, 16);
    expect(4, 1, 17, 17);
}

/// What stands at the second token, read as a type, and the token behind it.
std::string typeBehind(const std::string& text) {
    Lexer lexer(text);
    lexer.next();
    const Token second = lexer.next();
    const Token type = lexer.typeName(second);
    EXPECT_EQ(type.begin, second.begin);
    EXPECT_EQ(type.line, second.line);
    EXPECT_EQ(type.column, second.column);
    EXPECT_EQ(type.newLine, second.newLine);
    const std::string name(lexer.text(type));
    return name + " " + std::string(lexer.text(lexer.next()));
}

TEST(Lexer, TypesAreReadOnDemand) {
    EXPECT_EQ(typeBehind("var int x"), "int x");
    EXPECT_EQ(typeBehind("var /std_msgs/Float64 x"), "/std_msgs/Float64 x");
    EXPECT_EQ(typeBehind("var /a-b/C[] x"), "/a-b/C[] x");
    EXPECT_EQ(typeBehind("var\n  KDL.Frame x"), "KDL.Frame x");
    EXPECT_EQ(typeBehind("var vector</std/pair<a>> x"), "vector</std/pair<a>> x");
    EXPECT_EQ(typeBehind("var std::vector<int> x"), "std::vector<int> x");
    EXPECT_EQ(typeBehind("var int// y\nx"), "int x");
    EXPECT_EQ(typeBehind("var int/* y */x"), "int x");
}

TEST(Lexer, WhatIsNoTypeIsEmpty) {
    EXPECT_EQ(typeBehind("var 3"), " 3");
    EXPECT_EQ(typeBehind("var = 3"), " =");
    EXPECT_EQ(typeBehind("var"), " ");
}

}  // namespace
