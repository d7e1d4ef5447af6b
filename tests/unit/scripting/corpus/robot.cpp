// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "robot.hpp"

#include <rtt/extras/SlaveActivity.hpp>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace scripting_corpus {

using namespace RTT;

Worker::Worker(const std::string& name) : TaskContext(name) {
    addAttribute("offset", offset);
    addOperation("add", &Worker::add, this, OwnThread).doc("the sum").arg("a", "").arg("b", "");
    addOperation("swapValues", &Worker::swapValues, this, OwnThread);
    addOperation("split", &Worker::split, this, OwnThread);
    addOperation("waitForRelease", &Worker::waitForRelease, this, OwnThread);
    addOperation("release", &Worker::release, this, ClientThread);
    addOperation("fail", &Worker::fail, this, OwnThread);
    start();
}

Worker::~Worker() {
    release();
    stop();
}

int Worker::split(double value, double& rest) const {
    const double whole = std::floor(value);
    rest = value - whole;
    return static_cast<int>(whole);
}

int Worker::waitForRelease(int result) {
    std::unique_lock<std::mutex> lock(mutex_);
    released_.wait(lock, [this] { return permits_ > 0; });
    --permits_;
    return result;
}

void Worker::release() {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++permits_;
    released_.notify_all();
}

int Worker::fail() const { throw std::runtime_error("no power"); }

Robot::Robot() : TaskContext("robot") {
    setActivity(new extras::SlaveActivity(0.01));
    addValues();
    addFunctions();
    addServices();
    addPorts();
    addPeer(&other_);
    start();
}

Robot::~Robot() { stop(); }

void Robot::addValues() {
    addAttribute("flag", flag_);
    addAttribute("whole", whole_);
    addAttribute("natural", natural_);
    addAttribute("wide", wide_);
    addAttribute("wideNatural", wide_natural_);
    addAttribute("single", single_);
    addAttribute("real", real_);
    addAttribute("letter", letter_);
    addAttribute("text", text_);
    addAttribute("list", list_);
    addAttribute("names", names_);
    addAttribute("numbers", numbers_);
    addAttribute("policy", policy_);
    addAttribute("flow", flow_);
    addAttribute("sent", sent_);
    addAttribute("written", written_);
    addConstant("serial", serial_);
    addProperty("gain", gain_);
    limits_.ownProperty(new Property<double>("lower", "", lower_));
    limits_.ownProperty(new Property<double>("upper", "", upper_));
    addProperty("limits", limits_);
}

void Robot::addFunctions() {
    addOperation("note", &Robot::note, this, ClientThread).arg("text", "");
    addOperation("show", &Robot::show, this, ClientThread).arg("path", "");
    addOperation("step", &Robot::step, this, ClientThread).arg("times", "");
    addOperation("add", &Robot::add, this, OwnThread).arg("a", "").arg("b", "");
    addOperation("greet", &Robot::greet, this, ClientThread).arg("name", "");
    addOperation("half", &Robot::half, this, ClientThread).arg("value", "");
    addOperation("swapValues", &Robot::swapValues, this, OwnThread).arg("a", "").arg("b", "");
    addOperation("element", &Robot::element, this, ClientThread).arg("index", "");
    addOperation("refuse", &Robot::refuse, this, ClientThread);
    addOperation("fail", &Robot::fail, this, ClientThread);
    addOperation("truth", &Robot::truth, this, ClientThread).arg("name", "").arg("value", "");
    addOperation("comeAndGo", &Robot::comeAndGo, this, ClientThread).arg("script", "");
    addEventOperation(guessed_).arg("what", "");
    addEventOperation(moved_).arg("to", "");
    addEventOperation(measured_).arg("what", "").arg("value", "");
}

void Robot::addServices() {
    const Service::shared_ptr arm = provides("arm");
    arm->addProperty("speed", speed_);
    arm->addOperation("moveTo", [this](double to) { return note("arm at " + std::to_string(to)), to >= 0; });
    const Service::shared_ptr gripper = arm->provides("gripper");
    gripper->addAttribute("force", force_);
    gripper->addOperation("close", [this] { return note("closed"), ++force_; });
}

void Robot::addPorts() {
    addPort(out_);
    addPort(in_);
    addPort(jobs_);
    addPort(work_);
    addPort(loose_);
    addPort(opaque_);
    out_.createConnection(in_, ConnPolicy::data());
    jobs_.createConnection(work_, ConnPolicy::buffer(2));
}

std::vector<std::string> Robot::notes() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return notes_;
}

void Robot::note(const std::string& text) {
    const std::lock_guard<std::mutex> lock(mutex_);
    notes_.push_back(text);
}

/** Notes the text form of an attribute or property, or of a member of one. */
void Robot::show(const std::string& path) {
    std::istringstream parts(path);
    std::string part;
    std::getline(parts, part, '.');
    base::DataSourceBase::shared_ptr value;
    if (base::AttributeBase* attribute = provides()->getValue(part)) value = attribute->getDataSource();
    if (base::PropertyBase* property = provides()->getProperty(part)) value = property->getDataSource();
    while (value && std::getline(parts, part, '.')) value = value->getMember(part);
    std::ostringstream text;
    if (value)
        text << value;
    else
        text << "no " << path;
    note(text.str());
}

void Robot::step(int times) {
    for (int i = 0; i < times; ++i) getActivity()->execute();
}

void Robot::fail() const { throw std::runtime_error("broken gripper"); }

/** Has the script executed by a component that is destroyed then. */
bool Robot::comeAndGo(const std::string& script) const {
    TaskContext visitor("visitor");
    if (!visitor.loadService("scripting")) return false;
    OperationCaller<bool(const std::string&)> eval(visitor.provides("scripting")->getOperation("eval"), engine());
    return eval.ready() && eval(script);
}

/** Tells that it was asked. */
bool Robot::truth(const std::string& name, bool value) {
    note(name);
    return value;
}

}  // namespace scripting_corpus
