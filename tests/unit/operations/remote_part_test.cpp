// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Operations that a transport brings: a part of its own, with its own sources and handles.
#include "../flow/log_capture.hpp"
#include "../types/builtin_typekit.hpp"
#include "probe.hpp"

#include <rtt/FactoryExceptions.hpp>
#include <rtt/OperationInterfacePart.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/OperationCallerC.hpp>

using namespace RTT;
using namespace RTT::internal;
using oroforge::test::Probe;

namespace {

typedef base::DataSourceBase::shared_ptr Source;
typedef std::vector<Source> Sources;

/** `int scale(double factor, int& value)` on the other end of a wire. */
struct Wire {
    bool down = false;
    int calls = 0, collects = 0;
    std::string valueType = "int &";
    ExecutionEngine* caller = nullptr;
    int scale(double factor, int& value) {
        ++calls;
        value = static_cast<int>(value * factor);
        return calls;
    }
};

struct WireCall : DataSource<int> {
    WireCall(Wire& w, const Sources& args)
        : wire(w),
          factor(DataSource<double>::narrow(args[0].get())),
          changed(AssignableDataSource<int>::narrow(args[1].get())) {}
    bool evaluate() const override {
        if (wire.down) return false;
        result = wire.scale(factor->get(), changed->set());
        changed->updated();
        return true;
    }
    int get() const override { return evaluate() ? result : 0; }
    int value() const override { return result; }
    const int& rvalue() const override { return result; }
    DataSource<int>* clone() const override { return new WireCall(wire, {factor, changed}); }
    DataSource<int>* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>&) const override {
        return clone();
    }
    Wire& wire;
    DataSource<double>::shared_ptr factor;
    AssignableDataSource<int>::shared_ptr changed;
    mutable int result = 0;
};

/** What is known of a call that was sent. */
struct Ticket {
    int result = 0, value = 0;
    bool done = false;
};

struct WireSend : DataSource<Ticket> {
    explicit WireSend(WireCall* c) : call(c) {}
    Ticket get() const override {
        Ticket ticket;
        ticket.value = call->changed->get();
        ticket.result = call->wire.scale(call->factor->get(), ticket.value);
        ticket.done = !call->wire.down;
        return sent = ticket;
    }
    Ticket value() const override { return sent; }
    const Ticket& rvalue() const override { return sent; }
    DataSource<Ticket>* clone() const override { return new WireSend(call.get()); }
    DataSource<Ticket>* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>&) const override {
        return clone();
    }
    boost::intrusive_ptr<WireCall> call;
    mutable Ticket sent;
};

struct WireCollect : DataSource<SendStatus> {
    WireCollect(const Sources& args, DataSource<bool>::shared_ptr b)
        : ticket(DataSource<Ticket>::narrow(args[0].get())), values(args.begin() + 1, args.end()), blocking(b) {}
    SendStatus get() const override {
        const Ticket now = ticket->get();
        if (!now.done) return status = blocking->get() ? SendFailure : SendNotReady;
        if (!values.empty()) {
            AssignableDataSource<int>::narrow(values[0].get())->set(now.result);
            AssignableDataSource<int>::narrow(values[1].get())->set(now.value);
        }
        return status = SendSuccess;
    }
    SendStatus value() const override { return status; }
    const SendStatus& rvalue() const override { return status; }
    DataSource<SendStatus>* clone() const override { return nullptr; }
    DataSource<SendStatus>* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>&) const override {
        return nullptr;
    }
    DataSource<Ticket>::shared_ptr ticket;
    Sources values;
    DataSource<bool>::shared_ptr blocking;
    mutable SendStatus status = SendNotReady;
};

struct WirePart : OperationInterfacePart {
    explicit WirePart(Wire& w) : wire(w) {}
    std::string getName() const override { return "scale"; }
    std::string description() const override { return "Scales."; }
    std::vector<ArgumentDescription> getArgumentList() const override {
        return {{"factor", "", "double"}, {"value", "", wire.valueType}};
    }
    std::string resultType() const override { return "int"; }
    unsigned int arity() const override { return 2; }
    const types::TypeInfo* getArgumentType(unsigned int) const override { return nullptr; }
    unsigned int collectArity() const override { return 2; }
    const types::TypeInfo* getCollectType(unsigned int) const override { return nullptr; }
    base::DataSourceBase::shared_ptr produce(const std::vector<base::DataSourceBase::shared_ptr>& args,
                                             ExecutionEngine* caller) const override {
        return call(args, caller);
    }
    base::DataSourceBase::shared_ptr produceSend(const std::vector<base::DataSourceBase::shared_ptr>& args,
                                                 ExecutionEngine* caller) const override {
        return new WireSend(call(args, caller));
    }
    base::DataSourceBase::shared_ptr produceHandle() const override { return new ValueDataSource<Ticket>(); }
    base::DataSourceBase::shared_ptr produceCollect(const std::vector<base::DataSourceBase::shared_ptr>& args,
                                                    DataSource<bool>::shared_ptr blocking) const override {
        if (args.size() != 3 && args.size() != 1)
            throw wrong_number_of_args_exception(3, static_cast<int>(args.size()));
        ++wire.collects;
        return new WireCollect(args, blocking);
    }
    boost::shared_ptr<base::DisposableInterface> getLocalOperation() const override {
        return boost::shared_ptr<base::DisposableInterface>();
    }

    WireCall* call(const Sources& args, ExecutionEngine* caller) const {
        if (args.size() != 2) throw wrong_number_of_args_exception(2, static_cast<int>(args.size()));
        if (!DataSource<double>::narrow(args[0].get()))
            throw wrong_types_of_args_exception(1, "double", args[0]->getType());
        if (!AssignableDataSource<int>::narrow(args[1].get()))
            throw wrong_types_of_args_exception(2, "int", args[1]->getType());
        wire.caller = caller;
        return new WireCall(wire, args);
    }
    Wire& wire;
};

struct RemotePart : types_test::WithBuiltinTypes {
    Wire wire;
    Probe proxy{"proxy"};
    flow_test::LogCapture log;
    RemotePart() { proxy.operations()->add("scale", new WirePart(wire)); }
    OperationInterfacePart* part() { return proxy.getOperation("scale"); }
};

TEST_F(RemotePart, IsCalledLikeALocalOne) {
    OperationCaller<int(double, int&)> scale = part();
    ASSERT_TRUE(scale.ready()) << log.text();
    EXPECT_EQ(scale.getName(), "scale");
    int value = 4;
    EXPECT_EQ(scale(2.5, value), 1);
    EXPECT_EQ(value, 10);
    EXPECT_EQ(scale.call(0.5, value), 2);
    EXPECT_EQ(value, 5);
}

TEST_F(RemotePart, GetsTheEngineOfTheCaller) {
    Probe client("client");
    OperationCaller<void(double, int&)> scale(part(), client.engine());
    EXPECT_EQ(wire.caller, client.engine());
    int value = 4;
    scale(2, value);
    EXPECT_EQ(value, 8) << "its result is ignored";
    scale.setCaller(proxy.engine());
    scale(2, value);
    EXPECT_EQ(wire.caller, proxy.engine());
}

TEST_F(RemotePart, FailedCallThrows) {
    OperationCaller<int(double, int&)> scale("scale", proxy.provides());
    wire.down = true;
    int value = 4;
    EXPECT_THROW(scale(2, value), SendError);
    EXPECT_EQ(value, 4);
}

TEST_F(RemotePart, SendsAndCollects) {
    OperationCaller<int(double, int&)> scale("scale");
    scale = proxy.provides();
    int value = 4, result = 0;
    SendHandle<int(double, int&)> handle = scale.send(1.5, value);
    ASSERT_TRUE(handle.ready()) << log.text();
    value = 100;
    EXPECT_EQ(handle.collectIfDone(result, value), SendSuccess);
    EXPECT_EQ(result, 1);
    EXPECT_EQ(value, 6);
    wire.down = true;
    handle = scale.send(1.5, value);
    EXPECT_EQ(handle.collectIfDone(result, value), SendNotReady);
    EXPECT_EQ(handle.collect(), SendFailure);
    EXPECT_EQ(value, 6);
}

TEST_F(RemotePart, WrongSignatureIsRefused) {
    OperationCaller<int(double)> scale = part();
    EXPECT_FALSE(scale.ready());
    EXPECT_TRUE(log.contains("int (double, int &)") && log.contains("int (double)")) << log.text();
    EXPECT_FALSE((OperationCaller<int(double, const int&)>(part()).ready()));
    EXPECT_EQ(scale(1.0), 0);
}

TEST_F(RemotePart, WhatItChangesFollowsFromTheEndOfTheTypeName) {
    for (const char* changed : {"/my/constraint &", "int&"}) {
        wire.valueType = changed;
        EXPECT_FALSE((OperationCaller<int(double, const int&)>(part()).ready())) << changed;
        int value = 4, result = 0;
        auto handle = OperationCaller<int(double, int&)>(part()).send(1.5, value);
        ASSERT_TRUE(handle.ready()) << log.text();
        EXPECT_EQ(handle.collect(result, value), SendSuccess);
        EXPECT_EQ(value, 6);
    }
    for (const char* constant : {"int const&", "int const &", "const int&", "int"}) {
        wire.valueType = constant;
        EXPECT_TRUE((OperationCaller<int(double, const int&)>(part()).ready())) << constant;
    }
}

TEST_F(RemotePart, IsUsedByGenericCallersAndRequesters) {
    int value = 3, result = 0;
    OperationCallerC generic(part(), "scale", proxy.engine());
    EXPECT_TRUE(generic.argC(3.0).arg(value).ret(result).call());
    EXPECT_EQ(value, 9);
    SendHandleC handle = generic.send();
    EXPECT_EQ(handle.arg(result).arg(value).collect(), SendSuccess);
    EXPECT_EQ(wire.collects, 1);
    EXPECT_EQ(result, 2);
    EXPECT_EQ(value, 27);

    OperationCaller<int(double, int&)> scale("scale");
    proxy.requires_("remote")->addOperationCaller(scale);
    EXPECT_TRUE(proxy.requires_("remote")->connectTo(proxy.provides()));
    EXPECT_EQ(scale(1, value), 3);
}

}  // namespace
