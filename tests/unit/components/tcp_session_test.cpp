// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The protocol without sockets: each command, its errors, frames, and what a hostile client may send.
#include <reporting/frame_text.hpp>
#include <reporting/record.hpp>
#include <reporting/tcp_session.hpp>

#include <gmock/gmock.h>

#include <random>
#include <string>

namespace {

using namespace OCL::reporting;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

const std::string kGreeting = "100 Orocos 1.0 TcpReporting Server 1.0\n";

Field named(const std::string& name, Field::Kind kind = Field::Kind::Value, std::vector<Field> parts = {}) {
    Field field;
    field.name = name;
    field.kind = kind;
    field.parts = std::move(parts);
    return field;
}

Field group(const std::string& name, std::vector<Field> parts) {
    return named(name, Field::Kind::Group, std::move(parts));
}

Field sequence(const std::string& name, Field element) {
    return named(name, Field::Kind::Sequence, {std::move(element)});
}

/** What the rows of the tests consist of. */
Field report() {
    return group("", {named("TimeStamp"), named("M.speed"),
                      group("M.place", {named("x"), sequence("far", named("")), named("")}), named("M.late"),
                      named("M.two words")});
}

void putNumbers(Record& record, std::initializer_list<std::int64_t> values) {
    record.value(Tag::Sequence, static_cast<std::uint32_t>(values.size()));
    for (const std::int64_t value : values) record.value(Tag::Signed, value);
}

class Session : public testing::Test {
protected:
    std::string take() {
        const std::string text(session.backlog());
        session.sent(text.size());
        return text;
    }
    /** The replies to some text. */
    std::string say(const std::string& text) {
        (void)take();
        session.receive(text);
        return take();
    }
    void greet() { EXPECT_EQ("101 OK\n", say("VERSION 1.0\n")); }
    std::string frame(double speed = 1.5) {
        Record record;
        record.value(Tag::Real, 0.25);
        record.value(Tag::Real, speed);
        record.tag(Tag::Bag);
        record.value(Tag::Real, 1.0);
        putNumbers(record, {7, 8});
        record.value(Tag::Bool, true);
        record.tag(Tag::Absent);
        record.tag(Tag::Absent);
        row.decode(record.data(), record.size(), 6);
        EXPECT_TRUE(session.addFrame(row));
        return take();
    }

    FrameText row{report()};
    TcpSession session{row.names(), TcpLimits()};
};

TEST_F(Session, GreetsAndKnowsLittleBeforeVersion) {
    EXPECT_EQ(kGreeting, take());
    for (const char* command : {"HEADERS", "SUBS", "SUBSCRIBE TimeStamp", "SILENCE ON", "SETLIMIT 3", "LISTEXTENSIONS"})
        EXPECT_EQ("105 Command not found\n", say(std::string(command) + "\n")) << command;
    EXPECT_EQ("106 Not supported\n", say("VERSION 2.0\n"));
    EXPECT_EQ("102 Syntax: VERSION 1.0\n", say("VERSION\n"));
    EXPECT_EQ("Use HELP <command>\nVERSION\nHELP\nQUIT\nEXIT\n.\n", say("HELP\n"));
    greet();
    EXPECT_EQ("105 Command not found\n", say("VERSION 1.0\n"));
}

TEST_F(Session, ExplainsItsCommands) {
    greet();
    EXPECT_EQ(
        "Use HELP <command>\nHELP\nQUIT\nEXIT\nLISTEXTENSIONS\nHEADERS\nSUBSCRIBE\nUNSUBSCRIBE\nSUBS\nSILENCE\n"
        "SETLIMIT\n.\n",
        say("HELP\n"));
    EXPECT_EQ("Name: SUBSCRIBE\nUsage: SUBSCRIBE <name>\n", say("help subscribe\n"));
    EXPECT_EQ("Name: SUBS\nUsage: SUBS\n", say("HELP SUBS\n"));
    EXPECT_EQ("105 Command not found\n", say("HELP ME\n"));
    EXPECT_EQ("102 Syntax: HELP [<command>]\n", say("HELP SUBS SUBS\n"));
    EXPECT_EQ("103 none\n", say("LISTEXTENSIONS\n"));
}

TEST_F(Session, SubscribesAndLists) {
    greet();
    EXPECT_EQ("305 TimeStamp\n305 M.speed\n305 M.place\n305 M.late\n305 M.two words\n306 End of list\n",
              say("HEADERS\n"));
    EXPECT_EQ("302 M.speed\n", say("SUBSCRIBE M.speed\n"));
    EXPECT_EQ("301 M.speed\n", say("SUBSCRIBE M.speed\n"));
    EXPECT_EQ("301 m.speed\n", say("SUBSCRIBE m.speed\n"));
    EXPECT_EQ("302 TimeStamp\n302 M.two words\n", say("subscribe\tTimeStamp\nSubscribe  M.two words \n"));
    EXPECT_EQ("305 M.speed\n305 TimeStamp\n305 M.two words\n306 End of list\n", say("SUBS\n"));
    EXPECT_EQ("303 M.speed\n304 M.speed\n304 none\n",
              say("UNSUBSCRIBE M.speed\nUNSUBSCRIBE M.speed\nUNSUBSCRIBE none\n"));
    EXPECT_EQ("305 TimeStamp\n305 M.two words\n306 End of list\n", say("SUBS\n"));
}

TEST_F(Session, NamesTheSyntaxOfACommand) {
    greet();
    for (const char* command : {"SUBSCRIBE", "SUBSCRIBE a b", "UNSUBSCRIBE", "UNSUBSCRIBE a b"})
        EXPECT_THAT(say(std::string(command) + "\n"), testing::MatchesRegex("102 Syntax: (UN)?SUBSCRIBE <name>\n"));
    for (const char* command : {"SILENCE", "SILENCE maybe", "SILENCE ON OFF"})
        EXPECT_EQ("102 Syntax: SILENCE ON | OFF\n", say(std::string(command) + "\n"));
    for (const char* command :
         {"SETLIMIT", "SETLIMIT x", "SETLIMIT -1", "SETLIMIT 1.5", "SETLIMIT 1 2", "SETLIMIT 99999999999999999999999"})
        EXPECT_EQ("102 Syntax: SETLIMIT <frame>\n", say(std::string(command) + "\n"));
    EXPECT_EQ("102 Syntax: SUBS\n", say("SUBS all\n"));
    EXPECT_EQ("102 Syntax: HEADERS\n", say("HEADERS all\n"));
    EXPECT_EQ("102 Syntax: QUIT\n", say("QUIT now\n"));
    EXPECT_EQ("102 Syntax: LISTEXTENSIONS\n", say("LISTEXTENSIONS all\n"));
}

TEST_F(Session, SendsFramesOfWhatIsSubscribed) {
    greet();
    EXPECT_EQ("", frame());  // nothing is subscribed, and it is not counted
    say("SUBSCRIBE M.place\nSUBSCRIBE TimeStamp\n");
    EXPECT_EQ(
        "201 0 -- begin of frame\n202 M.place\n202 x\n205 1\n202 far\n202 0\n205 7\n202 1\n205 8\n202 3\n205 1\n"
        "202 TimeStamp\n205 0.25\n203 0 -- end of frame\n",
        frame());
    say("UNSUBSCRIBE M.place\nSUBSCRIBE M.late\n");  // which this row does not have
    EXPECT_EQ("201 1 -- begin of frame\n202 TimeStamp\n205 0.25\n203 1 -- end of frame\n", frame());
}

TEST_F(Session, IsSilentWhenTold) {
    greet();
    say("SUBSCRIBE M.speed\n");
    EXPECT_EQ("107 Silence ON\n", say("SILENCE on\n"));
    EXPECT_EQ("", frame());
    EXPECT_EQ("107 Silence OFF\n", say("SILENCE OFF\n"));
    EXPECT_EQ("201 0 -- begin of frame\n202 M.speed\n205 1.5\n203 0 -- end of frame\n", frame());
}

TEST_F(Session, StopsAtItsLimitAndGoesOnWithAnother) {
    greet();
    say("SUBSCRIBE M.speed\n");
    EXPECT_EQ("101 OK\n", say("SETLIMIT 1\n"));
    EXPECT_THAT(frame(), EndsWith("203 0 -- end of frame\n"));
    EXPECT_THAT(frame(), EndsWith("203 1 -- end of frame\n204 Limit reached\n"));
    EXPECT_EQ("", frame());
    say("SETLIMIT 1\n");
    EXPECT_EQ("204 Limit reached\n", frame());
    EXPECT_EQ("", frame());
    say("SETLIMIT 0\n");
    EXPECT_THAT(frame(), EndsWith("203 2 -- end of frame\n"));
}

TEST_F(Session, SaysByeAndNothingMore) {
    (void)take();
    session.receive("quit\nHELP\n");
    EXPECT_EQ("104 Bye bye", take());
    EXPECT_TRUE(session.ended());
    session.receive("HELP\n");
    EXPECT_EQ("", take());
}

TEST_F(Session, AcceptsLineEndsOfBothKindsAndHalfLines) {
    EXPECT_EQ("101 OK\n", say("VERSION 1.0\r\n"));
    EXPECT_EQ("", say("SUB"));
    EXPECT_EQ("", say("S\r"));
    EXPECT_EQ("306 End of list\n", say("\n"));
    EXPECT_EQ("105 Command not found\n105 Command not found\n", say("\r\n\n"));
}

TEST_F(Session, DropsLongLines) {
    greet();
    const std::string longest = "SUBSCRIBE " + std::string(90, 'x');
    EXPECT_EQ("301 " + std::string(90, 'x') + "\n", say(longest + "\r\n"));
    EXPECT_EQ("105 Command not found\n", say(longest + "x\n"));
    for (int i = 0; i < 1000; ++i) EXPECT_EQ("", say(std::string(4096, 'x')));
    EXPECT_EQ("105 Command not found\n306 End of list\n", say("SUBS\nSUBS\n"));  // the first one ends the long line
    EXPECT_EQ("105 Command not found\n306 End of list\n", say(std::string(200, 'x') + "\nSUBS\n"));
}

TEST_F(Session, KeepsNamesAndValuesOnTheirLines) {
    FrameText odd(group("", {named("TimeStamp"), group("M.a\nb", {named("c\r\n203 d"), named("e"), named("empty")})}));
    TcpSession client(odd.names(), TcpLimits());
    client.receive("VERSION 1.0\nHEADERS\nSUBSCRIBE M.a\\nb\nSUBSCRIBE M.\rx\n");
    EXPECT_THAT(client.backlog(), EndsWith("305 M.a\\nb\n306 End of list\n302 M.a\\nb\n301 M.\\rx\n"));
    client.sent(client.backlog().size());
    Record record;
    record.value(Tag::Real, 0.0);
    record.tag(Tag::Bag);
    record.text(Tag::Text, std::string_view("1\n203 0 -- end of frame\r\x01\t\0.", 28));
    record.value(Tag::Char, '\n');
    record.text(Tag::Text, "");
    odd.decode(record.data(), record.size(), 6);
    EXPECT_TRUE(client.addFrame(odd));
    EXPECT_EQ(
        "201 0 -- begin of frame\n202 M.a\\nb\n202 c\\r\\n203 d\n205 1\\n203 0 -- end of frame\\r\\x01\t\\x00.\n"
        "202 e\n205 \\n\n202 empty\n205 \n203 0 -- end of frame\n",
        client.backlog());
}

TEST_F(Session, WritesValuesAsTheyAre) {
    FrameText words(group("", {named("TimeStamp"), named("M.words")}));
    TcpSession client(words.names(), TcpLimits());
    client.receive("VERSION 1.0\nSUBSCRIBE M.words\n");
    client.sent(client.backlog().size());
    Record record;
    record.value(Tag::Real, 0.0);
    record.text(Tag::Text, " two  \"words\", #1\\n\tand more ");
    words.decode(record.data(), record.size(), 6);
    EXPECT_TRUE(client.addFrame(words));
    EXPECT_EQ("201 0 -- begin of frame\n202 M.words\n205  two  \"words\", #1\\n\tand more \n203 0 -- end of frame\n",
              client.backlog());
}

TEST_F(Session, SendsAsManyElementsAsARowHas) {
    FrameText words(group("", {sequence("M.far", group("", {named("x"), sequence("", named(""))}))}));
    TcpSession client(words.names(), TcpLimits());
    client.receive("VERSION 1.0\nSUBSCRIBE M.far\n");
    const std::string elements[] = {"202 0\n202 x\n205 3\n202 2\n202 0\n205 7\n",
                                    "202 1\n202 x\n205 3\n202 2\n202 0\n205 7\n"};
    for (const std::uint32_t count : {0U, 1U, 2U, 0U}) {
        Record record;
        record.value(Tag::Sequence, count);
        std::string expected = "-- begin of frame\n202 M.far\n";
        for (std::uint32_t i = 0; i != count; ++i) {
            record.tag(Tag::Bag);
            record.value(Tag::Signed, std::int64_t{3});
            putNumbers(record, {7});
            expected += elements[i];
        }
        words.decode(record.data(), record.size(), 6);
        client.sent(client.backlog().size());
        EXPECT_TRUE(client.addFrame(words));
        EXPECT_THAT(client.backlog(), HasSubstr(expected + "203 "));
    }
}

TEST_F(Session, TakesOtherMembersFromOneRowToTheNext) {
    FrameText bag(group("", {group("M.bag", {})}));
    TcpSession client(bag.names(), TcpLimits());
    client.receive("VERSION 1.0\nSUBSCRIBE M.bag\n");
    Record record;
    record.tag(Tag::Bag);
    bag.decode(record.data(), record.size(), 6);
    client.sent(client.backlog().size());
    EXPECT_TRUE(client.addFrame(bag));
    EXPECT_EQ("201 0 -- begin of frame\n202 M.bag\n203 0 -- end of frame\n", client.backlog());
    bag.adopt(group("", {group("M.bag", {named("new")})}));
    record.text(Tag::Text, "here");
    bag.decode(record.data(), record.size(), 6);
    client.sent(client.backlog().size());
    EXPECT_TRUE(client.addFrame(bag));
    EXPECT_EQ("201 1 -- begin of frame\n202 M.bag\n202 new\n205 here\n203 1 -- end of frame\n", client.backlog());
}

TEST_F(Session, DropsWholeFramesOfAClientThatDoesNotTakeThem) {
    TcpLimits limits;
    limits.backlog = 500;
    TcpSession slow(row.names(), limits);
    slow.receive("VERSION 1.0\nSUBSCRIBE M.speed\n");
    session.receive("VERSION 1.0\n");
    (void)frame();
    int dropped = 0;
    for (int i = 0; i < 20; ++i) dropped += slow.addFrame(row) ? 0 : 1;
    EXPECT_GT(dropped, 5);
    EXPECT_LE(slow.backlog().size(), 500U);
    EXPECT_THAT(slow.backlog(), EndsWith("-- end of frame\n"));
    slow.sent(slow.backlog().size());
    EXPECT_TRUE(slow.addFrame(row));
    EXPECT_THAT(slow.backlog(), HasSubstr("201 20 -- begin"));  // the gap shows what is missing
}

TEST_F(Session, SendsAFrameThatIsLargerThanTheBacklogMayBe) {
    TcpLimits limits;
    limits.backlog = 10;
    TcpSession client(row.names(), limits);
    client.sent(client.backlog().size());
    client.receive("VERSION 1.0\nSUBSCRIBE M.place\n");
    client.sent(client.backlog().size());
    (void)frame();
    EXPECT_TRUE(client.addFrame(row) || client.backlog().empty());
    client.sent(client.backlog().size());
    EXPECT_TRUE(client.addFrame(row));
    EXPECT_GT(client.backlog().size(), 50U);
    EXPECT_FALSE(client.addFrame(row));
}

TEST_F(Session, AClientThatDoesNotReadRepliesWaitsWithItsCommands) {
    TcpLimits limits;
    limits.backlog = 1000;
    TcpSession client(row.names(), limits);
    client.receive("VERSION 1.0\n");
    std::string commands;
    for (int i = 0; i < 500; ++i) commands += "HEADERS\n";
    client.receive(commands);
    EXPECT_TRUE(client.full());
    EXPECT_LT(client.backlog().size(), 1200U);
    std::string all;
    while (!client.backlog().empty()) {
        all += client.backlog().substr(0, 100);
        client.sent(std::min<std::size_t>(100, client.backlog().size()));
    }
    int lists = 0;
    for (std::size_t at = 0; (at = all.find("306 ", at)) != all.npos; ++at) ++lists;
    EXPECT_EQ(500, lists);
}

TEST_F(Session, TakesAnyBytesInAnyPieces) {
    std::mt19937 random(31);
    const char* const words[] = {"VERSION 1.0\n", "HEADERS\n",     "SUBSCRIBE M.speed\n",     "SUBSCRIBE ",
                                 "SETLIMIT ",     "SILENCE OFF\n", "UNSUBSCRIBE M.speed\r\n", "\xff\xfe\r",
                                 "SUBS\n",        "99999999999999"};
    for (int round = 0; round < 300; ++round) {
        TcpLimits limits;
        limits.backlog = 1 + random() % 2000;
        TcpSession client(row.names(), limits);
        for (int step = 0; step < 100; ++step) {
            std::string bytes = random() % 2 != 0 ? words[random() % 10] : "";
            for (unsigned int left = random() % 8; left != 0; --left) bytes += static_cast<char>(random());
            if (random() % 5 == 0) bytes += '\n';
            client.receive(bytes);
            if (random() % 10 == 0) (void)client.addFrame(row);
            client.sent(random() % (client.backlog().size() + 1));
            ASSERT_LT(client.backlog().size(), limits.backlog + 400);
        }
        client.receive("\nHELP\n");
        std::string all;
        while (!client.backlog().empty()) {
            all += client.backlog();
            client.sent(client.backlog().size());
        }
        EXPECT_THAT(all, EndsWith("\n.\n"));
    }
}

}  // namespace
