// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Two typekits that share a type, and a component: whatever the order of loading and the flags of dlopen, all agree on
// what the type is. Types are never unregistered, so each combination runs in a child process.
#include <rtt/DataFlowInterface.hpp>
#include <rtt/Property.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/types/Types.hpp>

#include <gtest/gtest.h>

#include <dlfcn.h>
#include <memory>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace {

struct Library {
    void* handle = nullptr;
    template <class F> F* symbol(const char* name) const { return reinterpret_cast<F*>(dlsym(handle, name)); }
};

Library open(const char* file, int flags) {
    Library library{dlopen(file, RTLD_NOW | flags)};
    EXPECT_NE(nullptr, library.handle) << dlerror();
    return library;
}

void loadTypekit(const Library& library) {
    auto* load = library.symbol<bool(RTT::TaskContext*)>("loadRTTPlugin");
    ASSERT_NE(nullptr, load);
    EXPECT_TRUE(load(nullptr));
}

using MakeOutput = RTT::base::OutputPortInterface*();
using MakeInput = RTT::base::InputPortInterface*();

void writeHereReadThere(const Library& writer, const Library& reader) {
    const std::unique_ptr<RTT::base::OutputPortInterface> out(writer.symbol<MakeOutput>("makeOutput")());
    const std::unique_ptr<RTT::base::InputPortInterface> in(reader.symbol<MakeInput>("makeInput")());
    ASSERT_TRUE(out->connectTo(in.get()));
    EXPECT_TRUE(reader.symbol<bool(RTT::base::OutputPortInterface*, double)>("writeValue")(out.get(), 4.5));
    EXPECT_EQ(4.5, writer.symbol<double(RTT::base::InputPortInterface*)>("readValue")(in.get()));
}

void expectAgreement(const Library& a, const Library& b, const Library& c) {
    using Info = const void*();
    RTT::types::TypeInfo* info = RTT::types::Types()->type("identity.A");
    ASSERT_NE(nullptr, info);
    EXPECT_EQ(info, RTT::types::Types()->type("identity.B")) << "the second name is an alias";
    for (const Library* library : {&a, &b, &c}) EXPECT_EQ(info, library->symbol<Info>("typeInfoSeenHere")());

    writeHereReadThere(a, b);
    writeHereReadThere(b, a);

    const std::unique_ptr<RTT::base::PropertyBase> property(a.symbol<RTT::base::PropertyBase*()>("makeProperty")());
    EXPECT_TRUE(b.symbol<bool(RTT::base::PropertyBase*)>("isSampleProperty")(property.get()));

    // From a port of one typekit through the component to a port that the type information makes.
    const std::unique_ptr<RTT::TaskContext> relay(c.symbol<RTT::TaskContext*()>("makeRelay")());
    const std::unique_ptr<RTT::base::OutputPortInterface> out(a.symbol<MakeOutput>("makeOutput")());
    const std::unique_ptr<RTT::base::InputPortInterface> in(info->inputPort("in"));
    ASSERT_TRUE(out->connectTo(relay->ports()->getPort("in")));
    ASSERT_TRUE(relay->ports()->getPort("out")->connectTo(in.get()));
    EXPECT_TRUE(b.symbol<bool(RTT::base::OutputPortInterface*, double)>("writeValue")(out.get(), 7));
    c.symbol<void(RTT::TaskContext*)>("stepRelay")(relay.get());
    EXPECT_EQ(7, b.symbol<double(RTT::base::InputPortInterface*)>("readValue")(in.get()));
    const auto value = relay->properties()->find("last")->getDataSource()->getMember("value");
    ASSERT_TRUE(value);
    EXPECT_EQ(7, RTT::internal::DataSource<double>::narrow(value.get())->get());
}

/** `order`: a permutation of the letters a, b (typekits) and c (component); `flags`: one of g (global), l (local) for each. */
void runCombination(const std::string& order, const std::string& flags) {
    Library a, b, c;
    loadTypekit(open(BUILTIN_TYPEKIT, RTLD_LOCAL));
    for (std::size_t i = 0; i != order.size(); ++i) {
        const int flag = flags[i] == 'g' ? RTLD_GLOBAL : RTLD_LOCAL;
        if (order[i] == 'a') loadTypekit(a = open(TYPEKIT_A, flag));
        if (order[i] == 'b') loadTypekit(b = open(TYPEKIT_B, flag));
        if (order[i] == 'c') c = open(COMPONENT, flag);
        // The component asks before a typekit is there, too.
        if (c.handle) c.symbol<const void*()>("typeInfoSeenHere")();
    }
    expectAgreement(a, b, c);
}

class TypeIdentity : public ::testing::TestWithParam<std::string> {};

}

TEST_P(TypeIdentity, AllAgreeInAProcessOfTheirOwn) {
    for (const char* flags : {"ggg", "ggl", "glg", "gll", "lgg", "lgl", "llg", "lll"}) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            runCombination(GetParam(), flags);
            fflush(nullptr);
            _exit(::testing::Test::HasFailure() ? 1 : 0);
        }
        int status = 0;
        ASSERT_EQ(child, waitpid(child, &status, 0));
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0)
            << "order " << GetParam() << ", dlopen flags " << flags << ", status " << status;
    }
}

INSTANTIATE_TEST_SUITE_P(Orders, TypeIdentity, ::testing::Values("abc", "acb", "bac", "bca", "cab", "cba"),
                         [](const auto& order) { return order.param; });
