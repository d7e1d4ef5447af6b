// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component with real clients: its life, its ports, clients that come, go, wait and do not read.
#include "tcp_fixture.hpp"

#include <atomic>
#include <sys/resource.h>

namespace {

using namespace components_test;

TEST_F(TcpReports, SendsRowsToAClient) {
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->reportPort("Machine", "place"));
    ASSERT_TRUE(reporter->reportPort("Machine", "mode"));
    ASSERT_TRUE(reporter->reportPort("Machine", "levels"));
    ASSERT_TRUE(reporter->reportData("Machine", "label"));
    ASSERT_TRUE(reporter->configure());
    ASSERT_TRUE(reporter->start());
    TcpPeer client(port());
    ASSERT_TRUE(client.greet());
    client.send("HEADERS\n");
    EXPECT_EQ((std::vector<std::string>{"305 TimeStamp", "305 Machine.speed", "305 Machine.place", "305 Machine.mode",
                                        "305 Machine.levels", "305 Machine.label", "306 End of list"}),
              client.lines(7));
    for (const char* name : {"Machine.label", "Machine.place", "Machine.mode", "Machine.levels"})
        EXPECT_EQ(std::string("302 ") + name, client.ask(std::string("SUBSCRIBE ") + name));
    machine.place.write({1.5, 2});
    machine.mode.write(sample::Mode::Draining);
    machine.label = "red\nblue";
    row();
    EXPECT_EQ((std::vector<std::string>{"201 0 -- begin of frame", "202 Machine.label", "205 red\\nblue",
                                        "202 Machine.place", "202 x", "205 1.5", "202 y", "205 2", "202 Machine.mode",
                                        "205 Draining", "202 Machine.levels", "203 0 -- end of frame"}),
              client.lines(12));
    machine.levels.write({0.25, 4});
    row();
    (void)client.lines(10);
    EXPECT_EQ((std::vector<std::string>{"202 Machine.levels", "202 0", "205 0.25", "202 1", "205 4",
                                        "203 1 -- end of frame"}),
              client.lines(6));
    client.send("QUIT\n");
    EXPECT_EQ("104 Bye bye", client.rest());
    client.endOutput();
    EXPECT_TRUE(hasClients(0));
}

TEST_F(TcpReports, ReportDataSelectsWhatIsReported) {
    property<RTT::PropertyBag>("ReportData").ownProperty(new RTT::Property<std::string>("Port", "", "Machine.speed"));
    ASSERT_TRUE(reporter->configure());
    ASSERT_TRUE(reporter->start());
    TcpPeer client(port());
    ASSERT_TRUE(client.greet());
    EXPECT_EQ("302 Machine.speed", client.ask("SUBSCRIBE Machine.speed"));
    ASSERT_TRUE(reporter->stop());
    property<RTT::PropertyBag>("ReportData").ownProperty(new RTT::Property<std::string>("Port", "", "Machine.none"));
    const LogText log;
    EXPECT_FALSE(reporter->configure());
    EXPECT_THAT(log(), HasSubstr("none"));
}

TEST_F(TcpReports, ReportsDataThatWakesIt) {
    property<bool>("Snapshot") = false;
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->start());
    TcpPeer client(port());
    ASSERT_TRUE(client.greet());
    EXPECT_EQ("302 Machine.speed", client.ask("SUBSCRIBE Machine.speed"));
    for (int i = 0; i < 3; ++i) {
        machine.speed.write(i);
        EXPECT_EQ(
            (std::vector<std::string>{"201 " + std::to_string(i) + " -- begin of frame", "202 Machine.speed",
                                      "205 " + std::to_string(i), "203 " + std::to_string(i) + " -- end of frame"}),
            client.lines(4));
    }
}

TEST_F(TcpReports, ChangedValuesOnlyIfWanted) {
    property<bool>("ReportOnlyNewData") = true;
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->reportData("Machine", "label"));
    ASSERT_TRUE(reporter->start());
    TcpPeer client(port());
    ASSERT_TRUE(client.greet());
    (void)client.ask("SUBSCRIBE Machine.speed");
    (void)client.ask("SUBSCRIBE Machine.label");
    row();
    (void)client.lines(4);
    machine.speed.write(3);
    row();
    EXPECT_EQ(
        (std::vector<std::string>{"201 1 -- begin of frame", "202 Machine.speed", "205 3", "203 1 -- end of frame"}),
        client.lines(4));
    machine.label = "red";
    row();
    EXPECT_EQ(
        (std::vector<std::string>{"201 2 -- begin of frame", "202 Machine.label", "205 red", "203 2 -- end of frame"}),
        client.lines(4));
}

TEST_F(TcpReports, TakesOneOfTheNextPorts) {
    ASSERT_TRUE(reporter->start());
    const unsigned int taken = port();
    std::vector<std::unique_ptr<OCL::TcpReporting>> others;
    const LogText log;
    unsigned int failed = 0;
    for (int i = 0; i < 5; ++i) {
        others.push_back(std::make_unique<OCL::TcpReporting>("Other"));
        dynamic_cast<RTT::Property<unsigned int>&>(*others.back()->getProperty("port")).value() = taken;
        if (!others.back()->start()) ++failed;
    }
    EXPECT_GE(failed, 1u);  // more, if other programs have some of these ports
    EXPECT_THAT(log(), HasSubstr("'Other' cannot listen: port " + std::to_string(taken)));
    EXPECT_THAT(log(), HasSubstr("in use; set the property 'port'"));
}

TEST_F(TcpReports, RefusesImpossibleProperties) {
    const LogText log;
    property<unsigned int>("port") = 70000;
    EXPECT_FALSE(reporter->start());
    EXPECT_THAT(log(), HasSubstr("70000 is not a port"));
    property<unsigned int>("port") = 0;
    property<std::string>("address") = "somewhere";
    EXPECT_FALSE(reporter->start());
    EXPECT_THAT(log(), HasSubstr("'somewhere' is not an address"));
    property<std::string>("address") = "192.0.2.1";  // of nobody
    EXPECT_FALSE(reporter->start());
    EXPECT_THAT(log(), HasSubstr("192.0.2.1"));
    property<std::string>("address") = "localhost";
    property<unsigned int>("max_clients") = 0;
    EXPECT_FALSE(reporter->start());
    property<unsigned int>("max_clients") = 1;
    property<unsigned int>("max_line") = 3;
    EXPECT_FALSE(reporter->start());
    property<unsigned int>("max_line") = 100;
    property<unsigned int>("max_backlog") = 0;
    EXPECT_FALSE(reporter->start());
    property<unsigned int>("max_backlog") = 100000;
    EXPECT_EQ(0u, port());
    EXPECT_TRUE(reporter->start());
    EXPECT_NE(0u, port());
}

TEST_F(TcpReports, StartsStopsAndMovesAgainAndAgain) {
    unsigned int last = 0;
    for (int round = 0; round < 20; ++round) {
        property<unsigned int>("port") = round % 3 == 0 ? 0 : last;
        ASSERT_TRUE(reporter->configure());  // nothing is reported: there is the time, at least
        ASSERT_TRUE(reporter->start());
        if (round % 3 != 0) {
            EXPECT_EQ(last, port());  // its connections have just been closed by this side
        }
        last = port();
        TcpPeer client(port());
        ASSERT_TRUE(client.greet());
        EXPECT_EQ("302 TimeStamp", client.ask("SUBSCRIBE TimeStamp"));
        row();
        ASSERT_TRUE(reporter->stop());
        EXPECT_EQ(0u, port());
        EXPECT_THAT(client.rest(), testing::EndsWith("203 0 -- end of frame\n"));  // all that was due, then the end
        EXPECT_FALSE(TcpPeer(last).connected());
        if (round % 2 == 0) {
            ASSERT_TRUE(reporter->cleanup());
        }
    }
}

TEST_F(TcpReports, IsDestroyedWhileClientsAreConnected) {
    ASSERT_TRUE(reporter->start());
    TcpPeer greeted(port()), silent(port());
    ASSERT_TRUE(greeted.greet());
    EXPECT_EQ("302 TimeStamp", greeted.ask("SUBSCRIBE TimeStamp"));
    ASSERT_TRUE(hasClients(2));
    row();
    reporter.reset();
    EXPECT_THAT(greeted.rest(), HasSubstr("203 0"));
    EXPECT_EQ("100 Orocos 1.0 TcpReporting Server 1.0\n", silent.rest());
}

TEST_F(TcpReports, AClientThatDoesNotReadLosesFramesAndAnotherOneNone) {
    constexpr int kRows = 3000;
    machine.label = std::string(4000, 'x');
    property<unsigned int>("max_backlog") = 1 << 20;
    ASSERT_TRUE(reporter->reportData("Machine", "label"));
    ASSERT_TRUE(reporter->start());
    TcpPeer stopped(port(), 4096), good(port());
    for (TcpPeer* client : {&stopped, &good}) {
        ASSERT_TRUE(client->greet());
        ASSERT_EQ("302 Machine.label", client->ask("SUBSCRIBE Machine.label"));
    }
    std::atomic<int> complete{0};
    std::atomic<bool> reading{true};
    std::thread reader([&] {
        for (int i = 0; i < kRows && reading; ++i) {
            const std::string number = std::to_string(i);
            const std::vector<std::string> frame = good.lines(4);
            reading = frame[0] == "201 " + number + " -- begin of frame" && frame[2].size() == 4004 &&
                      frame[3] == "203 " + number + " -- end of frame";
            if (reading) ++complete;
        }
    });
    for (int i = 0; i < kRows; ++i) {
        row();
        // A client that reads is at most as far behind as its backlog allows.
        while (reading && complete < i - 100) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    reader.join();
    EXPECT_EQ(kRows, complete.load());
    EXPECT_TRUE(updateUntil([this] { return count("dropped_frames") > 100; }));
    EXPECT_EQ(2u, count("clients"));
    // What the other one then finds are whole frames with growing numbers.
    ASSERT_TRUE(reporter->stop());
    long last = -1;
    int frames = 0;
    for (std::string line = stopped.line(); line.substr(0, 4) == "201 "; line = stopped.line(), ++frames) {
        EXPECT_GT(std::stol(line.substr(4)), last);
        last = std::stol(line.substr(4));
        const std::vector<std::string> rest = stopped.lines(2);
        if (rest[1].size() != 4004) break;  // the last one, which stop() did not wait for
        EXPECT_EQ("203 " + std::to_string(last) + " -- end of frame", stopped.line());
    }
    EXPECT_GT(frames, 10);
}

TEST_F(TcpReports, StopDoesNotWaitForAClientThatDoesNotRead) {
    machine.label = std::string(20000, 'x');
    property<unsigned int>("max_backlog") = 100000;
    ASSERT_TRUE(reporter->reportData("Machine", "label"));
    ASSERT_TRUE(reporter->start());
    TcpPeer stopped(port(), 4096);
    ASSERT_TRUE(stopped.greet());
    ASSERT_EQ("302 Machine.label", stopped.ask("SUBSCRIBE Machine.label"));
    ASSERT_TRUE(updateUntil([this] {
        row();
        return count("dropped_frames") > 0;
    }));
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_TRUE(reporter->stop());
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(3));
}

TEST_F(TcpReports, ServesAsManyClientsAsAllowed) {
    property<unsigned int>("max_clients") = 3;
    ASSERT_TRUE(reporter->start());
    const LogText log;
    std::vector<std::unique_ptr<TcpPeer>> clients;
    for (int i = 0; i < 3; ++i) {
        clients.push_back(std::make_unique<TcpPeer>(port()));
        ASSERT_TRUE(clients.back()->greet());
    }
    EXPECT_EQ("(end)", TcpPeer(port()).line());
    EXPECT_TRUE(updateUntil([this] { return count("refused_clients") == 1; }));
    clients.pop_back();
    ASSERT_TRUE(hasClients(2));
    EXPECT_TRUE(TcpPeer(port()).greet());
    ASSERT_TRUE(reporter->stop());  // its thread writes to the log
    EXPECT_THAT(log(), HasSubstr("'Reporter' refuses a client: it has 3 already"));
}

TEST_F(TcpReports, AClientThatSaysNothingLosesItsPlaceWhenItIsNeeded) {
    property<unsigned int>("max_clients") = 2;
    ASSERT_TRUE(reporter->start());
    TcpPeer silent(port()), greeted(port());
    ASSERT_TRUE(greeted.greet());
    ASSERT_EQ("100 Orocos 1.0 TcpReporting Server 1.0", silent.line());
    silent.send("VERS");
    EXPECT_EQ("(end)", TcpPeer(port()).line());  // not at once
    std::this_thread::sleep_for(std::chrono::milliseconds(5100));
    TcpPeer next(port());
    EXPECT_TRUE(next.greet());
    EXPECT_EQ("(end)", silent.line());
    EXPECT_EQ("306 End of list", greeted.ask("SUBS"));
}

TEST_F(TcpReports, SendsToAClientThatHasEndedItsOutput) {
    ASSERT_TRUE(reporter->start());
    TcpPeer client(port());
    client.send("VERSION 1.0\nSUBSCRIBE TimeStamp\n");
    client.endOutput();  // as nc and socat do at the end of their input
    EXPECT_EQ("302 TimeStamp", client.lines(3).back());
    row();
    EXPECT_EQ("201 0 -- begin of frame", client.line());
    TcpPeer list(port());
    list.send("VERSION 1.0\nHEADERS\n");
    list.endOutput();
    EXPECT_THAT(list.rest(), HasSubstr("306 End of list\n"));  // and its connection ends
    EXPECT_TRUE(hasClients(1));
}

TEST_F(TcpReports, TenThousandConnectionsDoNotDisturbAClient) {
    ASSERT_TRUE(reporter->start());
    TcpPeer client(port());
    ASSERT_TRUE(client.greet());
    ASSERT_EQ("302 TimeStamp", client.ask("SUBSCRIBE TimeStamp"));
    for (int i = 0; i < 10000; ++i) ASSERT_TRUE(TcpPeer(port()).connected());
    for (int i = 0; i < 10; ++i) {
        row();
        EXPECT_EQ("203 " + std::to_string(i) + " -- end of frame", client.lines(4).back());
    }
    EXPECT_TRUE(hasClients(1));
}

TEST_F(TcpReports, WaitsWithoutPollingWhenThereAreNoMoreFiles) {
    ASSERT_TRUE(reporter->start());
    TcpPeer first(port());
    ASSERT_TRUE(first.greet());
    rlimit before{};
    ASSERT_EQ(0, ::getrlimit(RLIMIT_NOFILE, &before));
    TcpPeer second(port());
    ASSERT_TRUE(second.greet());
    const int next = ::dup(0);
    ::close(next);
    // The client gets the last file, the server none.
    const rlimit tight{static_cast<rlim_t>(next) + 1, before.rlim_max};
    ASSERT_EQ(0, ::setrlimit(RLIMIT_NOFILE, &tight));
    TcpPeer third(port());
    rusage start{}, end{};
    ::getrusage(RUSAGE_SELF, &start);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    ::getrusage(RUSAGE_SELF, &end);
    ASSERT_EQ(0, ::setrlimit(RLIMIT_NOFILE, &before));
    const auto cpu = [](const rusage& usage) {
        return usage.ru_utime.tv_sec * 1000000 + usage.ru_utime.tv_usec + usage.ru_stime.tv_sec * 1000000 +
               usage.ru_stime.tv_usec;
    };
    EXPECT_LT(cpu(end) - cpu(start), 200000);
    EXPECT_EQ("306 End of list", first.ask("SUBS"));
    EXPECT_TRUE(third.greet());
}

TEST_F(TcpReports, IdleClientsCostNoTime) {
    ASSERT_TRUE(reporter->start());
    TcpPeer greeted(port()), silent(port()), half(port());
    ASSERT_TRUE(greeted.greet());
    half.send("VERSION 1.0\nSUBSCRIBE TimeStamp\n");
    half.endOutput();
    EXPECT_EQ("302 TimeStamp", half.lines(3).back());
    rusage start{}, end{};
    ::getrusage(RUSAGE_SELF, &start);
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    ::getrusage(RUSAGE_SELF, &end);
    EXPECT_LT(end.ru_nvcsw - start.ru_nvcsw + end.ru_nivcsw - start.ru_nivcsw, 40);
}

}  // namespace
