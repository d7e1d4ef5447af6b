// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components of all kinds, and a client that asks for them.
#ifndef OROFORGE_TEST_LIVE_REQUESTS_FIXTURE_HPP
#define OROFORGE_TEST_LIVE_REQUESTS_FIXTURE_HPP

#include <live/requests/requests.hpp>
#include <rtt/Activity.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/startstop.h>
#include <rtt/plugin/PluginLoader.hpp>

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace live_test {

using nlohmann::json;

/** A process with threads and types, once. */
inline void begin() {
    static const bool begun = [] {
        __os_init(0, nullptr);
        return RTT::plugin::PluginLoader::Instance()->loadLibrary(RTT_TYPEKIT_FILE) &&
               RTT::plugin::PluginLoader::Instance()->loadLibrary(RTT_SCRIPTING_FILE);
    }();
    ASSERT_TRUE(begun);
}

class Arm : public RTT::TaskContext {
public:
    explicit Arm(const std::string& name) : TaskContext(name) {
        addProperty("gain", gain).doc("How strongly it corrects [1/s]");
        addProperty("label", label).doc("Its label");
        addProperty("list", list);
        addProperty("flag", flag);
        addProperty("policy", policy);
        addAttribute("count", count);
        addConstant("limit", limit);
        ports()->addPort("out", out).doc("What it says");
        ports()->addPort("in", in);
        provides()->addOperation("add", &Arm::add, this, RTT::OwnThread).doc("Adds.").arg("a", "one").arg("b", "other");
        provides()->addOperation("addHere", &Arm::add, this, RTT::ClientThread);
        provides()->addOperation("block", &Arm::block, this, RTT::OwnThread);
        provides()->addOperation("blockHere", &Arm::block, this, RTT::ClientThread);
        provides()->addOperation("fails", &Arm::fails, this, RTT::OwnThread);
        provides()->addOperation("doubles", &Arm::doubles, this, RTT::OwnThread).arg("x", "in and out");
        provides()->addOperation("nothing", &Arm::nothing, this, RTT::OwnThread);
        provides("gripper")->addProperty("force", force);
        provides("gripper")->addOperation("open", &Arm::nothing, this, RTT::OwnThread);
        bag.ownProperty(new RTT::Property<double>("p", "Proportional", 1.5));
        bag.ownProperty(new RTT::Property<std::string>("mode", "", "slow"));
        addProperty("pid", bag);
    }
    ~Arm() override {
        release();
        stopForGood();
    }

    double add(double a, double b) {
        calledIn = std::this_thread::get_id();
        return a + b;
    }
    void block() {
        std::unique_lock<std::mutex> lock(mutex_);
        blocked = true;
        changed_.wait(lock, [this] { return released_; });
        blocked = false;
    }
    void release() {
        const std::lock_guard<std::mutex> lock(mutex_);
        released_ = true;
        changed_.notify_all();
    }
    void fails() { throw std::runtime_error("no power"); }
    void doubles(double& x) { x *= 2; }
    void nothing() {}
    bool startHook() override { return !refusesStart; }

    double gain = 2.5, force = 7;
    std::string label = "left";
    std::vector<double> list = {1, 2, 3};
    bool flag = false, refusesStart = false;
    int count = 4, limit = 9;
    RTT::ConnPolicy policy = RTT::ConnPolicy::buffer(12);
    RTT::PropertyBag bag;
    RTT::OutputPort<double> out;
    RTT::InputPort<double> in;
    std::atomic<std::thread::id> calledIn{};
    std::atomic<bool> blocked{false};

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool released_ = false;
};

class RequestsTest : public testing::Test {
protected:
    RequestsTest() {
        begin();
        deployer = std::make_unique<RTT::TaskContext>("Deployer");
        arm = std::make_unique<Arm>("Arm");
        deployer->addPeer(arm.get());
        requests = std::make_unique<OCL::live::Requests>(
            *deployer, OCL::live::Deployment{"cell", {"cell.xml"}, "1.2", 1764280000000000000},
            [this] { stopped = true; });
    }
    ~RequestsTest() override {
        arm.reset();
        requests.reset();
    }

    std::future<json> askLater(json request, const std::string& caller = "tester") {
        const auto promise = std::make_shared<std::promise<json>>();
        requests->handle(request, {caller, rights}, [promise](json answer) { promise->set_value(std::move(answer)); });
        return promise->get_future();
    }
    /** The answer; null if there is none within ten seconds. */
    json ask(json request) {
        auto answer = askLater(std::move(request));
        return answer.wait_for(std::chrono::seconds(10)) == std::future_status::ready ? answer.get() : json();
    }
    json result(const std::string& verb, json fields = json::object()) {
        fields["op"] = "oro." + verb;
        fields["id"] = 7;
        const json answer = ask(fields);
        EXPECT_EQ("oro.answer", answer.value("op", "")) << answer.dump(1);
        EXPECT_EQ(7, answer.value("id", 0));
        return answer.value("result", json());
    }
    /** "LIV003: there is no …" */
    std::string failure(const std::string& verb, json fields = json::object()) {
        fields["op"] = "oro." + verb;
        fields["id"] = "x";
        const json answer = ask(fields);
        EXPECT_EQ("oro.error", answer.value("op", "")) << answer.dump(1);
        EXPECT_EQ("x", answer.value("id", ""));
        return answer.value("code", "") + ": " + answer.value("message", "");
    }
    /** The element of that name in a list. */
    static json named(const json& list, const std::string& name) {
        for (const json& each : list)
            if (each.value("name", "") == name) return each;
        return json();
    }

    OCL::live::Rights rights{true, true, true, true, true};
    std::atomic<bool> stopped{false};
    std::unique_ptr<RTT::TaskContext> deployer;
    std::unique_ptr<Arm> arm;
    std::unique_ptr<OCL::live::Requests> requests;
};

}  // namespace live_test

#endif
