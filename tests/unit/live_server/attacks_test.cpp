// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A deployer with both doors, and clients that mean no good.
#include "target.hpp"

#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

namespace {

using live_test::freePort;
using live_test::kToken;
using live_test::RawClient;
using live_test::Target;
using nlohmann::json;
namespace fs = std::filesystem;

/** The processor time of a process, in s. */
double timeOf(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string word;
    for (int i = 0; i < 13; ++i) file >> word;
    double user = 0, system = 0;
    file >> user >> system;
    return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

TEST(LiveAttacks, RequestsAreRefused) {
    const Target target;
    const std::string good = "Host: localhost\r\n", upgrade = RawClient::upgrade("oro.v1"), path = Target::target();
    const auto get = [](const std::string& where, const std::string& fields) {
        return "GET " + where + " HTTP/1.1\r\n" + fields + "\r\n";
    };
    const struct {
        const char* name;
        std::string bytes;
        const char* status;  // "": the connection is closed, with or without an answer
    } attacks[] = {
        {"no token", get("/", good + upgrade), "401"},
        {"wrong token", get("/?token=0123456789abcdef0123456789abcdee", good + upgrade), "401"},
        {"first part of the token", get("/?token=0123456789abcdef", good + upgrade), "401"},
        {"empty token", get("/?token=", good + upgrade), "401"},
        {"longer token", get(path + "0", good + upgrade), "401"},
        {"other parameter", get("/?xtoken=" + kToken, good + upgrade), "401"},
        {"wrong bearer", get("/", good + upgrade + "Authorization: Bearer x\r\n"), "401"},
        {"basic instead of bearer", get("/", good + upgrade + "Authorization: Basic " + kToken + "\r\n"), "401"},
        {"rebinding", get(path, "Host: evil.example\r\n" + upgrade), "403"},
        {"rebinding with a port", get(path, "Host: evil.example:8765\r\n" + upgrade), "403"},
        {"host that begins well", get(path, "Host: 127.0.0.1.evil.example\r\n" + upgrade), "403"},
        {"host behind the port", get(path, "Host: 127.0.0.1:1@evil.example\r\n" + upgrade), "403"},
        {"list of hosts", get(path, "Host: localhost:1,evil.example\r\n" + upgrade), "403"},
        {"port that is none", get(path, "Host: localhost:99999\r\n" + upgrade), "403"},
        {"two hosts", get(path, good + "Host: evil.example\r\n" + upgrade), "400"},
        {"two pages", get(path, good + upgrade + "Origin: http://localhost\r\nOrigin: http://evil.example\r\n"), "400"},
        {"two tokens", get("/", good + upgrade + "Authorization: Bearer " + kToken + "\r\nAuthorization: x\r\n"),
         "400"},
        {"page with a port that is none", get(path, good + upgrade + "Origin: http://localhost:evil\r\n"), "403"},
        {"no host", get(path, upgrade), "400"},
        {"foreign page", get(path, good + upgrade + "Origin: http://evil.example\r\n"), "403"},
        {"sandboxed page", get(path, good + upgrade + "Origin: null\r\n"), "403"},
        {"page that begins well", get(path, good + upgrade + "Origin: http://localhost.evil.example\r\n"), "403"},
        {"other method", "POST " + path + " HTTP/1.1\r\n" + good + "\r\n", "405"},
        {"file", get("/etc/passwd", good), "404"},
        {"file upwards", get("/../../etc/passwd?token=" + kToken, good), "404"},
        {"plain request without token", get("/", good), "401"},
        {"long header", get(path, good + "X: " + std::string(9000, 'x') + "\r\n"), "431"},
        {"unknown subprotocol", get(path, good + RawClient::upgrade("rosbridge")), "400"},
        {"old version",
         get(path, good + "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 8\r\nSec-WebSocket-Key: "
                          "dGhlIHNhbXBsZSBub25jZQ==\r\n"),
         ""},
        {"no key", get(path, good + "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"), ""},
        {"body", get(path, good + upgrade + "Content-Length: 5\r\n") + "hello", ""},
        {"message before the answer", get(path, good + upgrade) + RawClient::frame("{}"), "400"},
        {"TLS", std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", 11) + std::string(500, '\x7f'), ""},
        {"noise", std::string(5000, '\xff'), ""},
        {"old HTTP", "GET /\r\n\r\n", ""},
        {"zero byte in a field", get(path, good + upgrade + std::string("X: a\0b\r\n", 8)), ""},
        {"nothing but line ends", std::string(9000, '\n'), ""},
    };
    for (const auto& attack : attacks) {
        RawClient client = target.web();
        ASSERT_TRUE(client.send(attack.bytes)) << attack.name;
        const std::string answer = client.all(3000);
        EXPECT_EQ(std::string::npos, answer.find(" 101 ")) << attack.name;
        if (*attack.status) EXPECT_EQ(std::string("HTTP/1.1 ") + attack.status, answer.substr(0, 12)) << attack.name;
        EXPECT_TRUE(client.closes(0)) << attack.name;
        EXPECT_EQ(std::string::npos, answer.find("root:")) << attack.name;
        EXPECT_EQ(std::string::npos, answer.find(kToken)) << attack.name;
    }
    target.expectHealth("requests");
}

TEST(LiveAttacks, FramesEndTheirConnectionOnly) {
    const Target target;
    const auto frame = [](const std::string& text, unsigned char head) { return RawClient::frame(text, head); };
    const struct {
        const char* name;
        std::string bytes;
    } attacks[] = {
        {"not masked", RawClient::frame("{}", 0x81, UINT64_MAX, false)},
        {"giant length", RawClient::frame("x", 0x81, 0x7FFFFFFFFFFFFFFF)},
        {"length beyond 63 bits", RawClient::frame("x", 0x81, 0xFFFFFFFFFFFFFFFE)},
        {"message of 64 KiB and a byte", frame(std::string(65537, ' '), 0x81)},
        {"fragments without end", frame(std::string(60000, ' '), 0x01) + frame(std::string(60000, ' '), 0x00)},
        {"reserved opcode", frame("", 0x83)},
        {"reserved bits", frame("{}", 0xF1)},
        {"continuation of nothing", frame("{}", 0x80)},
        {"long ping", frame(std::string(126, 'x'), 0x89)},
        {"fragment of a ping", frame("x", 0x09)},
        {"text that is not UTF-8", frame("\xc3\x28", 0x81)},
        {"half a surrogate", frame("\xed\xa0\x80", 0x81)},
        {"close with a wrong code", frame(std::string("\x03\xed", 2), 0x88)},
    };
    for (const auto& attack : attacks) {
        RawClient client = target.local();
        ASSERT_TRUE(client.open()) << attack.name;
        (void)client.send(attack.bytes);
        EXPECT_TRUE(client.closes(3000)) << attack.name;
    }
    {
        RawClient cut = target.local();
        ASSERT_TRUE(cut.open());
        ASSERT_TRUE(cut.send(frame(std::string(1000, ' '), 0x81).substr(0, 500)));
    }
    target.expectHealth("frames");
}

TEST(LiveAttacks, WrongMessagesAreAnsweredByErrors) {
    const Target target({"--web-allow=properties"});
    RawClient client = target.web();
    ASSERT_TRUE(client.open("oro.v1", Target::target()));
    const std::string deep(30000, '[');
    for (const std::string& text :
         {std::string("not JSON"), std::string("[]"), std::string("{}"), std::string(R"({"op":1,"id":1})"), deep,
          R"({"op":"oro.hello","id":)" + deep + "}", std::string(R"({"op":"oro.hello","id":{}})"),
          R"({"op":"oro.hello","id":")" + std::string(100, 'x') + "\"}", std::string(R"({"op":"oro.nothing","id":1})"),
          std::string(R"({"op":"oro.watch","id":1})"), std::string(R"({"op":"oro.watch","id":1,"port":"a.b"})"),
          std::string(R"({"op":"oro.watch","id":1,"port":"a","rate":-1})"),
          std::string(R"({"op":"oro.watch","id":1,"port":"a","buffer":1e300})"),
          std::string(R"({"op":"oro.unwatch","id":1,"watch":9})"), std::string(R"({"op":"oro.log","id":1,"level":9})"),
          std::string(R"({"op":"oro.log","id":1,"follow":1})"), std::string(R"({"op":"oro.stop","id":1})"),
          std::string(R"({"op":"oro.line","id":1,"line":"quit"})"),
          std::string(R"({"op":"oro.lifecycle","id":1,"component":"Deployer","do":"start"})")}) {
        ASSERT_TRUE(client.send(RawClient::frame(text)));
        EXPECT_EQ("oro.error", client.hear().value("op", "")) << text.substr(0, 100);
    }
    ASSERT_TRUE(client.send(RawClient::frame("\x02xx", 0x82)));
    EXPECT_EQ("oro.error", client.hear().value("op", ""));
    RawClient fox = target.web();
    ASSERT_TRUE(fox.open("foxglove.sdk.v1", Target::target()));
    EXPECT_EQ("serverInfo", fox.hear().value("op", ""));
    for (const std::string& text : {std::string("x"), std::string(R"({"op":"advertise","channels":[]})"),
                                    std::string(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":77}]})"),
                                    std::string(R"({"op":"subscribe","subscriptions":[1]})")}) {
        ASSERT_TRUE(fox.send(RawClient::frame(text)));
        EXPECT_FALSE(fox.hear("status").is_null()) << text;
    }
    for (const std::string& bytes :
         {std::string(), std::string("\x02"), std::string("\x02\x01\0\0\0\x01\0\0\0\xff\xff\xff\xff{}", 15)}) {
        ASSERT_TRUE(fox.send(RawClient::frame(bytes, 0x82)));
        EXPECT_FALSE(fox.hear("status").is_null());
    }
    ASSERT_TRUE(fox.send(RawClient::frame(std::string("\x02\x01\0\0\0\x07\0\0\0\x04\0\0\0json{}", 19), 0x82)));
    EXPECT_EQ(7, fox.hear("serviceCallFailure").value("callId", 0));
}

TEST(LiveAttacks, ThousandsOfConnectionsAndSlowOnesKeepNobodyOut) {
    const Target target;
    std::vector<RawClient> slow;
    for (int i = 0; i < 60; ++i) {
        slow.push_back(target.web());
        (void)slow.back().send("GET / HTTP/1.1\r\nHost: loc");
    }
    target.expectHealth("slow headers");
    for (int i = 0; i < 10000; ++i) {
        RawClient client = i % 2 ? target.web() : target.local();
        if (i % 3 == 0) (void)client.send("GET / HT");
    }
    target.expectHealth("ten thousand connections");
}

TEST(LiveAttacks, TheSeventeenthClientIsToldWhy) {
    const Target target;
    std::vector<RawClient> clients;
    for (int i = 0; i < 16; ++i) {
        clients.push_back(target.web());
        ASSERT_TRUE(clients.back().open("oro.v1", Target::target()));
    }
    RawClient more = target.web();
    ASSERT_TRUE(more.send("GET " + Target::target() + " HTTP/1.1\r\nHost: localhost\r\n" +
                          RawClient::upgrade("oro.v1") + "\r\n"));
    EXPECT_EQ("HTTP/1.1 503", more.all(3000).substr(0, 12));
    RawClient local = target.local();
    EXPECT_TRUE(local.open()) << "clients of the web took the places of the user's own";
}

TEST(LiveAttacks, AClientThatReadsNothingDelaysNobody) {
    const Target target;
    RawClient deaf = target.local();
    ASSERT_TRUE(deaf.open());
    const timeval limit{0, 200000};
    (void)::setsockopt(deaf.socket(), SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
    const std::string question = RawClient::frame(R"({"op":"oro.show","id":1,"path":"Deployer"})");
    for (int i = 0; i < 20000 && deaf.send(question); ++i) {
    }
    target.expectHealth("a deaf client");
    std::ifstream file("/proc/" + std::to_string(target.child->pid()) + "/statm");
    long pages = 0;
    file >> pages >> pages;
    EXPECT_LT(pages * 4096, 200L << 20U);
}

TEST(LiveAttacks, AForeignUserDoesNotGetIn) {
    if (::geteuid() != 0) GTEST_SKIP() << "only root can be somebody else";
    const Target target({}, /*web=*/false);
    const std::string file = target.socketFile();
    // Where the modes of folder and file do not keep others out, the kernel's word on the peer does.
    ASSERT_EQ(0, ::chmod(target.directory.path().c_str(), 0755));
    ASSERT_EQ(0, ::chmod((target.directory / "oroforge").c_str(), 0755));
    ASSERT_EQ(0, ::chmod(file.c_str(), 0666));
    const pid_t child = ::fork();
    if (child == 0) {
        if (::setgid(65534) != 0 || ::setuid(65534) != 0) ::_exit(2);
        RawClient client = RawClient::unixSocket(file);
        ::_exit(client.connected() && !client.open() ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(child, ::waitpid(child, &status, 0));
    EXPECT_EQ(0, WEXITSTATUS(status));
    RawClient own = target.local();
    EXPECT_TRUE(own.open());
}

TEST(LiveAttacks, WithoutFilesItWaits) {
    for (const bool loaded : {false, true}) {
        const Target target({}, /*web=*/false);
        std::unique_ptr<RawClient> first;
        if (loaded) {
            first = std::make_unique<RawClient>(target.local());
            ASSERT_TRUE(first->open());
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(200));  // until what has started is asleep
        rlimit before{}, none{0, 0};
        ASSERT_EQ(0, ::prlimit(target.child->pid(), RLIMIT_NOFILE, nullptr, &before));
        none.rlim_max = before.rlim_max;
        ASSERT_EQ(0, ::prlimit(target.child->pid(), RLIMIT_NOFILE, &none, nullptr));
        RawClient client = target.local();
        const double begin = timeOf(target.child->pid());
        std::this_thread::sleep_for(std::chrono::milliseconds(700));
        EXPECT_LT(timeOf(target.child->pid()) - begin, 0.1);
        ASSERT_EQ(0, ::prlimit(target.child->pid(), RLIMIT_NOFILE, &before, nullptr));
        EXPECT_TRUE(client.open()) << "loaded: " << loaded;
    }
}

TEST(LiveWindow, ProgramsThatComponentsStartDoNotInheritItsSockets) {
    const Target target;
    target.expectHealth("start");
    const fs::path process = "/proc/" + std::to_string(target.child->pid());
    int sockets = 0;
    for (const auto& entry : fs::directory_iterator(process / "fd")) {
        std::error_code none;
        if (fs::read_symlink(entry, none).string().compare(0, 7, "socket:") != 0) continue;
        std::ifstream file(process / "fdinfo" / entry.path().filename());
        unsigned flags = 0;
        for (std::string word; file >> word;)
            if (word == "flags:") file >> std::oct >> flags;
        ++sockets;
        EXPECT_NE(0U, flags & O_CLOEXEC) << entry;
    }
    EXPECT_GE(sockets, 2);
}

TEST(LiveWindow, EndsInOrderWhileClientsAreConnected) {
    Target target;
    RawClient local = target.local(), web = target.web(), half = target.web(), gone = target.local();
    ASSERT_TRUE(local.open() && web.open("foxglove.websocket.v1", Target::target()) && gone.open());
    ASSERT_TRUE(local.say({{"op", "oro.log"}, {"id", 1}}));
    ASSERT_EQ(1, local.hear("oro.answer").value("id", 0));
    ASSERT_TRUE(half.send("GET"));
    const std::string file = target.socketFile();
    target.child->send(SIGTERM);
    const auto outcome = target.child->finish();
    EXPECT_EQ(0, outcome.status);
    EXPECT_TRUE(local.closes() && web.closes() && half.closes());
    EXPECT_FALSE(fs::exists(file));
}

TEST(LiveWindow, IsNotThereForProgramsThatCheckOrDoNotWantIt) {
    for (const char* option : {"--no-live", "--check", "--dry-run"}) {
        const oroforge::test::TempDir directory;
        oroforge::test::Command command;
        command.program = DEPLOYER_PROGRAM;
        const std::string file = directory.write("a.ops", "var int a = 1\n");
        command.arguments = {option, "-s", file};
        command.directory = directory.path();
        command.environment = {{"XDG_RUNTIME_DIR", directory.path().string()}, {"ORO_LOGFILE", "/dev/null"}};
        (void)oroforge::test::run(command);
        EXPECT_FALSE(fs::exists(directory / "oroforge")) << option;
    }
}

TEST(LiveWindow, APortInUseIsAnErrorBeforeAnythingIsDeployed) {
    const Target target;
    const oroforge::test::TempDir directory;
    oroforge::test::Command command;
    command.program = DEPLOYER_PROGRAM;
    command.directory = directory.path();
    command.environment = {{"XDG_RUNTIME_DIR", directory.path().string()}, {"ORO_LOGFILE", "/dev/null"}};
    const auto runWith = [&](const std::vector<std::string>& words) {
        command.arguments = words;
        const auto outcome = oroforge::test::run(command);
        EXPECT_EQ(255, outcome.status) << words[0];
        return outcome.err;
    };
    EXPECT_NE(std::string::npos, runWith({"--web=" + std::to_string(target.port)}).find("--web: error: [WEB001]"));
    EXPECT_NE(std::string::npos, runWith({"--web=x"}).find("[WEB003]"));
    EXPECT_NE(std::string::npos, runWith({"--web=0.0.0.0:0"}).find("[WEB004]"));
    EXPECT_NE(std::string::npos, runWith({"--web=0", "--web-token-file=none"}).find("none: error: [WEB005]"));
    EXPECT_NE(std::string::npos, runWith({"--web=0", "--web-allow=propertys"}).find("did you mean 'properties'"));
    EXPECT_NE(std::string::npos, runWith({"--web=0", "--web-origin=view.example"}).find("--web-origin is no site"));
    EXPECT_NE(std::string::npos, runWith({"--web-origin=https://a"}).find("without --web"));
    EXPECT_NE(std::string::npos, runWith({"--web-allow=operations"}).find("without --web"));
}

TEST(LiveWindow, AForeignFolderIsAWarning) {
    const oroforge::test::TempDir directory;
    fs::create_directory(directory / "other");
    fs::create_directory_symlink(directory / "other", directory / "oroforge");
    oroforge::test::Command command;
    command.program = DEPLOYER_PROGRAM;
    command.directory = directory.path();
    command.environment = {{"XDG_RUNTIME_DIR", directory.path().string()}, {"ORO_LOGFILE", "/dev/null"}};
    command.input = "1+1\n";
    const auto outcome = oroforge::test::run(command);
    EXPECT_EQ(0, outcome.status);
    EXPECT_NE(std::string::npos, outcome.err.find("oroforge: warning: [WEB002] it is a symbolic link")) << outcome.err;
    EXPECT_TRUE(fs::is_empty(directory / "other"));
}

}  // namespace
