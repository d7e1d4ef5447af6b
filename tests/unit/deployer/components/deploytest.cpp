// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components for the deployment tests. They tell on standard output what happens to them.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/types/StructTypeInfo.hpp>
#include <rtt/types/Types.hpp>

#include <boost/serialization/nvp.hpp>

#include <iostream>
#include <memory>
#include <stdexcept>

namespace deploytest {

/** Tells of every change of its state. */
class Telling : public RTT::TaskContext {
public:
    explicit Telling(const std::string& name, TaskState initial = Stopped) : RTT::TaskContext(name, initial) {
        tell("created");
    }
    ~Telling() override {
        stop();
        tell("deleted");
    }

protected:
    bool configureHook() override { return tell("configured"); }
    bool startHook() override { return tell("started"); }
    void stopHook() override { tell("stopped"); }
    void cleanupHook() override { tell("cleaned up"); }

    bool tell(const std::string& what) const {
        std::cout << getName() + ": " + what + "\n" << std::flush;
        return true;
    }
};

/** Writes 1, 2, 3 … in its period. */
class Producer : public Telling {
public:
    explicit Producer(const std::string& name) : Telling(name, PreOperational) {
        addPort("numbers", numbers_);
        addProperty("first", first_).doc("The first number");
        addProperty("label", label_);
    }

private:
    bool startHook() override {
        next_ = first_;
        return Telling::startHook();
    }
    void updateHook() override { numbers_.write(next_++); }

    RTT::OutputPort<int> numbers_;
    int first_ = 1;
    std::string label_;
    int next_ = 1;
};

/** Checks that numbers follow each other. */
class Consumer : public Telling {
public:
    explicit Consumer(const std::string& name) : Telling(name) {
        addEventPort("numbers", numbers_);
        addPort("text", text_);
    }

private:
    void updateHook() override {
        int number = 0;
        while (numbers_.read(number) == RTT::NewData) {
            if (received_ == 0)
                tell("first number " + std::to_string(number));
            else if (number != last_ + 1)
                tell("lost numbers before " + std::to_string(number));
            last_ = number;
            if (++received_ == 10) tell("ten numbers in a row");
        }
    }

    RTT::InputPort<int> numbers_;
    RTT::InputPort<std::string> text_;
    int received_ = 0;
    int last_ = 0;
};

/** Has its port only after it was configured. */
class Late : public Telling {
public:
    explicit Late(const std::string& name) : Telling(name, PreOperational) {}

private:
    bool configureHook() override {
        addPort("numbers", numbers_);
        return Telling::configureHook();
    }
    RTT::OutputPort<int> numbers_;
};

class ThrowsInConstructor : public Telling {
public:
    explicit ThrowsInConstructor(const std::string& name) : Telling(name) {
        throw std::runtime_error("no hardware at address 7");
    }
};

class RefusesToConfigure : public Telling {
public:
    explicit RefusesToConfigure(const std::string& name) : Telling(name, PreOperational) {}

private:
    bool configureHook() override { return false; }
};

class RefusesToStart : public Telling {
public:
    explicit RefusesToStart(const std::string& name) : Telling(name) {}

private:
    bool startHook() override { return false; }
};

/** Starts itself when it is made, and its peers when it is configured. */
class Eager : public Telling {
public:
    explicit Eager(const std::string& name) : Telling(name) { start(); }

private:
    bool configureHook() override {
        for (const std::string& peer : getPeerList()) getPeer(peer)->start();
        return Telling::configureHook();
    }
};

struct Brought {
    double x = 1;

    template <class Archive>
    void serialize(Archive& archive, unsigned) {
        archive& boost::serialization::make_nvp("x", x);
    }
};

/** Brings along what scripts cannot know before: with its constructor, or when it is configured; also to its peers. */
class Brings : public Telling {
public:
    explicit Brings(const std::string& name) : Telling(name, PreOperational) {
        bring("early");
        addOperation("grow", &two);
    }

private:
    bool configureHook() override {
        bring("late");
        provides()->removeOperation("grow");
        addOperation("grow", &same);
        for (const std::string& peer : getPeerList()) getPeer(peer)->provides("added")->addOperation("two", &two);
        return Telling::configureHook();
    }
    void bring(const std::string& when) {
        const RTT::Service::shared_ptr global = RTT::internal::GlobalService::Instance();
        RTT::types::Types()->addType(new RTT::types::StructTypeInfo<Brought>(when + ".Type"));
        RTT::ComponentLoader::Instance()->addFactory(
            when + "::Component", [](std::string made) -> RTT::TaskContext* { return new Late(made); });
        global->provides(when)->addOperation("two", &two);
        global->addOperation(when + "Global", &two);
        provides(when + "Own")->addOperation("two", &two);
    }
    static int two() { return 2; }
    static int same(int number) { return number; }
};

}  // namespace deploytest

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(deploytest::Producer)
ORO_LIST_COMPONENT_TYPE(deploytest::Consumer)
ORO_LIST_COMPONENT_TYPE(deploytest::Late)
ORO_LIST_COMPONENT_TYPE(deploytest::ThrowsInConstructor)
ORO_LIST_COMPONENT_TYPE(deploytest::RefusesToConfigure)
ORO_LIST_COMPONENT_TYPE(deploytest::RefusesToStart)
ORO_LIST_COMPONENT_TYPE(deploytest::Eager)
ORO_LIST_COMPONENT_TYPE(deploytest::Brings)
