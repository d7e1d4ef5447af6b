// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <live/door/door.hpp>
#include <live/door/token.hpp>
#include <live/door/unix_address.hpp>
#include <live/door/web_address.hpp>
#include <live/server/access.hpp>
#include <live/server/host.hpp>
#include <live/server/live_client.hpp>
#include <live/server/message_queue.hpp>
#include <live/server/text_depth.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <sys/stat.h>

namespace {

using namespace OCL::live;
namespace fs = std::filesystem;

Frame frameOf(std::size_t size, char letter) { return {std::string(size, letter), false}; }

std::string drained(MessageQueue& queue) {
    std::string letters;
    for (Frame frame; queue.next(frame);) letters += frame.bytes[0];
    return letters;
}

TEST(MessageQueue, AnswersComeFirstAndTheNewestSampleOfAChannelStays) {
    MessageQueue queue(100);
    queue.addSample(1, frameOf(30, 'a'));
    queue.addSample(2, frameOf(30, 'b'));
    queue.addSample(2, frameOf(30, 'c'));
    queue.addAnswer(frameOf(500, 'A'));
    queue.addSample(2, frameOf(30, 'd'));  // 'b' makes room
    queue.addSample(3, frameOf(30, 'e'));  // 'c', because 'a' and 'd' are the newest of theirs
    EXPECT_EQ(2U, queue.dropped(2));
    EXPECT_EQ(0U, queue.dropped(1));
    EXPECT_EQ(90U, queue.sampleBytes());
    EXPECT_EQ("Aade", drained(queue));
    EXPECT_EQ(0U, queue.sampleBytes());
    EXPECT_EQ(0U, queue.answerBytes());
}

TEST(MessageQueue, TheLastMessageOfAChannelComesBehindItsSamples) {
    MessageQueue queue(100);
    queue.addSample(1, frameOf(30, 'a'));
    queue.addSample(2, frameOf(30, 'b'));
    queue.addBehind(1, frameOf(10, 'A'));
    queue.addBehind(3, frameOf(10, 'C'));  // nothing waits
    EXPECT_EQ("CaAb", drained(queue));
    queue.addSample(1, frameOf(60, 'a'));
    queue.addBehind(1, frameOf(10, 'A'));
    queue.addSample(2, frameOf(60, 'b'));  // drops 'a'
    EXPECT_EQ("Ab", drained(queue));
    queue.setLimit(200);
    queue.addSample(1, frameOf(100, 'a'));
    queue.addBehind(1, frameOf(10, 'A'));
    queue.forget(1);
    queue.addSample(2, frameOf(100, 'b'));
    EXPECT_EQ("Ab", drained(queue));
    EXPECT_EQ(0U, queue.sampleBytes());
    EXPECT_EQ(0U, queue.answerBytes());
}

TEST(MessageQueue, ASampleLargerThanTheLimitDropsAllOthersAndIsKept) {
    MessageQueue queue(100);
    queue.addSample(1, frameOf(60, 'a'));
    queue.addSample(2, frameOf(500, 'b'));
    EXPECT_EQ(1U, queue.dropped(1));
    EXPECT_EQ("b", drained(queue));
    queue.addSample(2, frameOf(10, 'c'));
    queue.forget(2);
    EXPECT_EQ(0U, queue.dropped(2));
    EXPECT_EQ("", drained(queue));
}

/** One component with a property that is another one each time. */
class ChangingHost final : public Host, public Link {
public:
    void ask(std::uint64_t, const nlohmann::json& request, const Caller&, Then then) override {
        nlohmann::json result;
        if (request["op"] == "oro.tree")
            result["components"] = {{{"name", "Arm"}, {"services", nlohmann::json::array()}}};
        else
            result["properties"] = {{{"name", "text"}, {"type", "string"}, {"value", text()}}};
        then(*client, {{"op", "oro.answer"}, {"id", 0}, {"result", result}});
    }
    void forward(std::uint64_t, const nlohmann::json&, const Caller&) override {}
    std::unique_ptr<PortWatch> watch(const std::string&, const PortWatch::Options&) override { return nullptr; }
    bool describe(const std::string&, nlohmann::json&, std::string&) override { return false; }
    void wantsChanged() override {}
    void wake() override {}
    std::string text() { return std::string(60000, static_cast<char>('a' + ++asked % 26)); }

    LiveClient* client = nullptr;
    int asked = 0;
};

TEST(LiveClient, OneThatDoesNotReadGetsNoEndlessUpdates) {
    ChangingHost host;
    LiveClient client(host, 1, {"tester", {}}, host, /*speaksFoxglove=*/true);
    host.client = &client;
    client.receive(R"({"op":"subscribeParameterUpdates","parameterNames":["Arm.text"]})", false);
    for (std::int64_t second = 1; second != 100; ++second) client.onTick(second * 1000000000);
    std::size_t bytes = 0;
    for (Frame frame; client.next(frame);) bytes += frame.bytes.size();
    EXPECT_LT(bytes, 1200000U);
    EXPECT_GT(bytes, 60000U);
    client.onTick(200000000000);
    Frame frame;
    EXPECT_TRUE(client.next(frame)) << "it goes on when the client reads again";
}

TEST(Access, PagesOfNamedSitesMayConnect) {
    WebAccess access{"0123456789abcdef", true, {"https://view.example", "http://10.0.0.5:8080"}};
    RequestHead head;
    head.isUpgrade = true;
    head.method = "GET";
    head.target = "/?token=0123456789abcdef";
    head.host = "localhost:8765";
    const auto status = [&](const char* origin) {
        head.origin = origin;
        return judgeRequest(head, access).status;
    };
    EXPECT_EQ(101U, status("https://view.example"));
    EXPECT_EQ(101U, status("https://View.Example"));
    EXPECT_EQ(101U, status("http://10.0.0.5:8080"));
    for (const char* other : {"http://view.example", "https://view.example.evil", "https://view.example:444",
                              "http://10.0.0.5", "https://evil.example", "null"})
        EXPECT_EQ(403U, status(other)) << other;
    head.isLocal = true;  // a page does not reach that door
    EXPECT_EQ(403U, status("https://view.example"));
    head.isLocal = false;
    head.target = "/";
    EXPECT_EQ(401U, status("https://view.example")) << "it needs the token, too";
}

TEST(TextDepth, CountsWhatIsNotInTexts) {
    EXPECT_EQ(0U, depthOf("1"));
    EXPECT_EQ(2U, depthOf(R"({"a": [1], "b": "[[[[", "c": "\\\"[[["})"));
    EXPECT_TRUE(isTooDeep(std::string(33, '[')));
    EXPECT_FALSE(isTooDeep(std::string(32, '[')));
}

TEST(Token, IsRandomAndComparedAsAWhole) {
    EXPECT_EQ(32U, newToken().size());
    EXPECT_NE(newToken(), newToken());
    EXPECT_TRUE(areEqual("abc", "abc"));
    for (const char* wrong : {"", "ab", "abcd", "abcabc", "abd"}) EXPECT_FALSE(areEqual(wrong, "abc")) << wrong;
    EXPECT_FALSE(areEqual("", ""));
}

TEST(Token, AFileThatOthersCanReadIsRefused) {
    const oroforge::test::TempDir directory;
    const std::string file = directory.write("token", "0123456789abcdef\n");
    std::string error;
    ASSERT_EQ(0, ::chmod(file.c_str(), 0644));
    EXPECT_EQ("", readToken(file, error));
    EXPECT_NE(std::string::npos, error.find("chmod 600"));
    ASSERT_EQ(0, ::chmod(file.c_str(), 0600));
    EXPECT_EQ("0123456789abcdef", readToken(file, error));
    for (const char* text : {"", "short\n", "0123456789abcde&x=1\n", "\n0123456789abcdef\n"}) {
        std::ofstream(file) << text;
        EXPECT_EQ("", readToken(file, error)) << text;
    }
    EXPECT_EQ("", readToken(directory / "none", error));
    EXPECT_EQ("", readToken(directory.path(), error));
}

TEST(WebAddress, HasAddressAndPort) {
    const struct {
        const char* text;
        const char* host;
        unsigned port;
    } good[] = {{"127.0.0.1:8765", "127.0.0.1", 8765}, {"0", "127.0.0.1", 0},         {":9", "127.0.0.1", 9},
                {"localhost:1", "127.0.0.1", 1},       {"[::1]:65535", "::1", 65535}, {"[::1]", "::1", 8765},
                {"0.0.0.0", "0.0.0.0", 8765}};
    WebAddress address;
    std::string error;
    for (const auto& row : good) {
        EXPECT_TRUE(parseWebAddress(row.text, address, error)) << row.text << error;
        EXPECT_EQ(row.host, address.host) << row.text;
        EXPECT_EQ(row.port, address.port) << row.text;
    }
    for (const char* text : {"robot", "robot:1", "127.0.0.1:", "127.0.0.1:65536", "127.0.0.1:-1", "[::1", "[::1]x:1",
                             "::1", "127.0.0.1:8x", "1.2.3"})
        EXPECT_FALSE(parseWebAddress(text, address, error)) << text;
    EXPECT_TRUE(parseWebAddress("127.8.8.8", address, error) && address.isLoopback());
    EXPECT_FALSE(parseWebAddress("0.0.0.0", address, error) && address.isLoopback());
    EXPECT_FALSE(parseWebAddress("[::]", address, error) && address.isLoopback());
}

TEST(SocketFolder, IsOnlyThatOfTheUser) {
    const oroforge::test::TempDir directory;
    SocketFolder::Fault fault;
    const SocketFolder made(directory / "made", fault);
    ASSERT_TRUE(made) << fault.text;
    EXPECT_EQ(fs::perms::owner_all, fs::status(made.path()).permissions());
    ASSERT_EQ(0, ::chmod(made.path().c_str(), 0777));
    ASSERT_TRUE(SocketFolder(made.path(), fault));
    EXPECT_EQ(fs::perms::owner_all, fs::status(made.path()).permissions());
    fs::create_directory_symlink(made.path(), directory / "link");
    EXPECT_FALSE(SocketFolder(directory / "link", fault));
    EXPECT_TRUE(fault.isForeign);
    (void)directory.write("file", "");
    EXPECT_FALSE(SocketFolder(directory / "file", fault));
    fault = {};
    EXPECT_FALSE(SocketFolder(directory / "none/folder", fault));
    EXPECT_FALSE(fault.isForeign);
    if (::geteuid() != 0) return;
    const SocketFolder foreign(directory / "foreign", fault);
    ASSERT_EQ(0, ::chown(foreign.path().c_str(), 12345, 12345));
    EXPECT_FALSE(SocketFolder(directory / "foreign", fault));
    EXPECT_TRUE(fault.isForeign);
}

TEST(SocketFolder, SocketsOfDeadProcessesAreRemovedAndOthersStay) {
    const oroforge::test::TempDir directory;
    SocketFolder::Fault fault;
    const SocketFolder folder(directory / std::string(120, 'x'), fault);  // too long for an address
    std::string error;
    {
        DoorSocket socket(folder, socketName("Arm"), error);
        ASSERT_TRUE(socket) << error;
        const fs::path file = fs::path(folder.path()) / socketName("Arm");
        EXPECT_EQ(fs::perms::owner_read | fs::perms::owner_write, fs::status(file).permissions());
        folder.removeStale();
        EXPECT_TRUE(fs::exists(file));
        {
            DoorSocket dead(folder, "4194303-Dead.sock", error);
            ASSERT_TRUE(dead) << error;
            folder.removeStale();  // nobody has the number, but it takes connections
            EXPECT_TRUE(fs::exists(fs::path(folder.path()) / "4194303-Dead.sock"));
            fs::rename(fs::path(folder.path()) / "4194303-Dead.sock", fs::path(folder.path()) / "4194302-Dead.sock");
        }
        folder.removeStale();
        EXPECT_FALSE(fs::exists(fs::path(folder.path()) / "4194302-Dead.sock"));
    }
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(SocketName, IsCutBetweenCharacters) {
    std::string name;
    for (int i = 0; i < 50; ++i) name += "ü";
    const std::string cut = socketName(name);
    EXPECT_LE(cut.size(), 64U);
    const std::string kept = cut.substr(cut.find('-') + 1, cut.size() - cut.find('-') - 6);
    EXPECT_EQ(0U, kept.size() % 2);
    EXPECT_EQ(name.substr(0, kept.size()), kept);
}

}  // namespace
