// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What another thread can interrupt while this one executes what was typed.
#include "console_fixture.hpp"

#include <rtt/Activity.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/engine/interruption.hpp>

#include <atomic>
#include <exception>
#include <thread>

namespace {

using RTT::internal::Interruption;
using testing::HasSubstr;

/** Its operation "wait" ends once the other one lets it. */
class Waiting : public RTT::TaskContext {
public:
    Waiting() : TaskContext("waiting") {
        addOperation("wait", &Waiting::wait, this, RTT::OwnThread);
        addOperation("begin", &Waiting::begin, this, RTT::ClientThread);
        addOperation("waitInCode", &Waiting::waitInCode, this, RTT::ClientThread);
        setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0));
        start();
    }
    ~Waiting() override {
        over = true;
        stop();
    }

    std::atomic<bool> begun{false}, over{false};
    std::string thrown = "nothing";

private:
    void begin() { begun = true; }
    void wait() {
        begun = true;
        while (!over) std::this_thread::yield();
    }
    /** What a component does that calls another one. */
    void waitInCode() {
        RTT::OperationCaller<void()> caller(provides()->getLocalOperation("wait"),
                                            RTT::internal::GlobalEngine::Instance());
        try {
            caller();
        } catch (const std::exception& e) {
            thrown = e.what();
        }
    }
};

class InterruptionTest : public ConsoleTest {
protected:
    InterruptionTest() { plant.addPeer(&waiting); }

    /** Executes it and asks for its end once it has begun; `meanwhile` then lets it end. What it complains of. */
    template <class Meanwhile>
    std::string interrupt(const std::string& line, Meanwhile meanwhile) {
        out.str("");
        err.str("");
        Interruption interruption;
        std::thread other([&] {
            while (!waiting.begun) std::this_thread::yield();
            interruption.ask();
            meanwhile();
        });
        console->execute(line);
        other.join();
        return err.str();
    }
    std::string interrupt(const std::string& line) {
        return interrupt(line, [] {});
    }

    Waiting waiting;
};

TEST_F(InterruptionTest, EndsALoop) {
    EXPECT_THAT(interrupt("waiting.begin(); while true { }"), HasSubstr(": error: interrupted\n"));
    EXPECT_EQ(" = 2\n", answer("1 + 1"));
}

TEST_F(InterruptionTest, EndsWaitingForAComponent) {
    EXPECT_EQ(
        "typed:1:1: error: interrupted while waiting for operation 'wait', which goes on in its component\n"
        "waiting.wait()\n^\n",
        interrupt("waiting.wait()"));
}

TEST_F(InterruptionTest, IsNotSeenByCodeThatIsCalled) {
    const std::string complaint = interrupt("waiting.waitInCode(); 1", [this] {
        std::this_thread::sleep_for(std::chrono::nanoseconds(2 * Interruption::kLook));
        waiting.over = true;
    });
    EXPECT_EQ("nothing", waiting.thrown);
    EXPECT_EQ("typed:1:23: error: interrupted\nwaiting.waitInCode(); 1\n                      ^\n", complaint);
}

TEST_F(InterruptionTest, IsNoFailure) {
    interrupt("waiting.begin(); while true { }");
    EXPECT_FALSE(console->screen().failed);
}

TEST_F(InterruptionTest, OfTheCommandBeforeIsForgotten) {
    interrupt("waiting.begin(); while true { }");
    const Interruption next;
    EXPECT_EQ(" = 2\n", answer("1 + 1"));
    EXPECT_EQ("", err.str());
}

TEST_F(InterruptionTest, BeforeItBeginsHasNothingExecuted) {
    Interruption interruption;
    interruption.ask();
    EXPECT_THAT(complaint("waiting.begin()"), HasSubstr("typed:1:1: error: interrupted\n"));
    EXPECT_FALSE(waiting.begun);
}

TEST_F(InterruptionTest, ListenersAreToldByTheTimeTheyAreMade) {
    Interruption interruption;
    int told = 0;
    {
        const Interruption::Listener early([&told] { ++told; });
        EXPECT_EQ(0, told);
        interruption.ask();
        EXPECT_EQ(1, told);
        const Interruption::Listener late([&told] { ++told; });
        EXPECT_EQ(2, told);
    }
    interruption.ask();
    EXPECT_EQ(2, told);
}

}  // namespace
