// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Callers whose signature differs from that of the operation.
#include "../flow/log_capture.hpp"
#include "../types/builtin_typekit.hpp"
#include "probe.hpp"

#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/types/TypeConstructor.hpp>

using namespace RTT;
using oroforge::test::Probe;

namespace {

struct Unregistered {
    int number = 0;
};

struct WithoutDefault {
    explicit WithoutDefault(int n) : number(n) {}
    int number;
};

struct NoText : internal::DataSource<std::string> {
    bool evaluate() const override { return false; }
    std::string get() const override { return text; }
    std::string value() const override { return text; }
    const std::string& rvalue() const override { return text; }
    NoText* clone() const override { return new NoText(); }
    NoText* copy(std::map<const DataSourceBase*, DataSourceBase*>&) const override { return clone(); }
    std::string text;
};

/** Accepts characters, and fails. */
struct FailingConversion : types::TypeConstructor {
    base::DataSourceBase::shared_ptr build(const std::vector<base::DataSourceBase::shared_ptr>&) const override {
        return nullptr;
    }
    base::DataSourceBase::shared_ptr convert(base::DataSourceBase::shared_ptr from) const override {
        return internal::DataSource<char>::narrow(from.get()) ? new NoText() : nullptr;
    }
};

struct OtherSignature : types_test::WithBuiltinTypes {
    Probe c{"server"};
    ExecutionEngine* global = internal::GlobalEngine::Instance();
    flow_test::LogCapture log;

    OtherSignature() {
        c.addOperation("half", [](double x) { return x / 2; });
        c.addOperation("twice", [](int n) { return 2 * n; });
        c.addOperation("greet", [](const std::string& name) { return "hello " + name; });
        c.addOperation("greet_copy", [](std::string name) { return "hello " + name; });
        c.addOperation("nothing", [this](int n) { seen = n; });
        c.addOperation(
            "divide", [](int a, int b, int& rest) { return rest = a % b, a / b; }, OwnThread);
        c.addOperation("number_of", [](const Unregistered& u) { return u.number; });
        c.addOperation("measure", [this](int n, Unregistered& u) { return ++seen, u.number = 2 * n; });
        c.addOperation("numbered", [](int n) { return Unregistered{n}; });
        c.addOperation(
            "bad", [](double) -> double { throw std::runtime_error("planted"); }, OwnThread);
        c.addOperation("refuse", [](double) -> double { throw std::logic_error("direct"); });
    }
    OperationInterfacePart* part(const char* name) { return c.getOperation(name); }
    int seen = 0;
};

TEST_F(OtherSignature, ArgumentsAndResultsAreConverted) {
    OperationCaller<double(int)> half = part("half");
    ASSERT_TRUE(half.ready()) << log.text();
    EXPECT_EQ(half(5), 2.5);
    OperationCaller<double(int)> twice = part("twice");
    EXPECT_EQ(twice(4), 8.0);
    OperationCaller<int(int)> both = part("half");
    ASSERT_TRUE(both.ready()) << log.text();
    EXPECT_EQ(both(9), 4) << "as int(4.5)";
}

TEST_F(OtherSignature, ReferencesAndValuesOfOneTypeAreTheSame) {
    EXPECT_EQ(OperationCaller<std::string(std::string)>(part("greet"))("you"), "hello you");
    EXPECT_EQ(OperationCaller<std::string(const std::string&)>(part("greet_copy"))("you"), "hello you");
    EXPECT_EQ(OperationCaller<int(Unregistered)>(part("number_of"))(Unregistered{3}), 3) << "no typekit is needed";
    EXPECT_EQ(OperationCaller<Unregistered(const int&)>(part("numbered"))(4).number, 4);
    c.addOperation("last", [](int) -> const std::string& {
        static const std::string text = "last";
        return text;
    });
    EXPECT_EQ(OperationCaller<std::string(double)>(part("last"))(1), "last");
    EXPECT_FALSE(OperationCaller<const std::string&(std::string)>(part("greet")).ready())
        << "there is nothing it could refer to";
}

TEST_F(OtherSignature, ResultsCanBeIgnoredButNotInvented) {
    OperationCaller<void(int)> twice = part("twice");
    ASSERT_TRUE(twice.ready()) << log.text();
    twice(1);
    OperationCaller<int(int)> nothing = part("nothing");
    EXPECT_FALSE(nothing.ready());
    EXPECT_EQ(nothing(1), 0);
    EXPECT_EQ(seen, 0) << "was not called";
}

TEST_F(OtherSignature, ReferencesAreWrittenBackByTheComponentsThread) {
    OperationCaller<double(double, int, int&)> divide(part("divide"), global);
    ASSERT_TRUE(divide.ready()) << log.text();
    int rest = 0;
    EXPECT_EQ(divide(17.0, 5, rest), 3.0);
    EXPECT_EQ(rest, 2);
    EXPECT_FALSE((OperationCaller<int(int, int, const int&)>(part("divide"), global).ready()))
        << "what is constant cannot be changed";
    EXPECT_EQ((OperationCaller<int(int, int, int)>(part("divide"), global)(17, 5, rest)), 3)
        << "a copy can, and is dropped";
}

TEST_F(OtherSignature, WhatCannotBeConvertedIsRefusedWithBothSignatures) {
    OperationCaller<bool(const std::string&)> twice = part("twice");
    EXPECT_FALSE(twice.ready());
    for (const char* text : {"'twice'", "int (int)", "called as bool (string const&)", "argument 1"})
        EXPECT_TRUE(log.contains(text)) << text << " is not in: " << log.text();
    EXPECT_FALSE(OperationCaller<int()>(part("twice")).ready());
    EXPECT_FALSE((OperationCaller<int(int, int)>(part("twice")).ready()));
    EXPECT_FALSE(OperationCaller<Unregistered(int)>(part("twice")).ready());
    EXPECT_TRUE(log.contains("Unregistered (int)")) << "a type that has no other name: " << log.text();
}

TEST_F(OtherSignature, SentCallsAreCollectedWithConversion) {
    OperationCaller<double(double, int, int&)> divide(part("divide"), global);
    int unused = 0, rest = 0;
    double quotient = 0;
    SendHandle<double(double, int, int&)> handle = divide.send(17.0, 5, unused);
    ASSERT_TRUE(handle.ready()) << log.text();
    EXPECT_EQ(handle.collect(quotient, rest), SendSuccess);
    EXPECT_EQ(quotient, 3.0);
    EXPECT_EQ(rest, 2);
    EXPECT_EQ(unused, 0);
    EXPECT_EQ(handle.ret(), 3.0);

    SendHandle<void(int)> ignoring = OperationCaller<void(int)>(part("twice"), global).send(4);
    EXPECT_EQ(ignoring.collect(), SendSuccess);
    SendHandle<int(int, int, int)> dropping =
        OperationCaller<int(int, int, int)>(part("divide"), global).send(17, 5, 0);
    int result = 0;
    EXPECT_EQ(dropping.collect(result), SendSuccess);
    EXPECT_EQ(result, 3);
}

TEST_F(OtherSignature, SentCallOfWhichNothingIsTakenNeedsNoKnownTypes) {
    SendHandle<void(int)> handle = OperationCaller<void(int)>(part("numbered"), global).send(4);
    ASSERT_TRUE(handle.ready()) << log.text();
    EXPECT_EQ(handle.collect(), SendSuccess);
    SendHandle<int(int, Unregistered)> dropping =
        OperationCaller<int(int, Unregistered)>(part("measure"), global).send(4, Unregistered());
    int result = 0;
    EXPECT_EQ(dropping.collect(result), SendSuccess) << log.text();
    EXPECT_EQ(result, 8);
}

TEST_F(OtherSignature, WhatCannotBeCollectedIsNotSent) {
    OperationCaller<double(int, Unregistered&)> measure(part("measure"), global);
    Unregistered changed;
    EXPECT_EQ(measure(3, changed), 6.0);
    EXPECT_EQ(changed.number, 6) << "a call needs its address only";
    EXPECT_EQ(seen, 1);
    EXPECT_FALSE(measure.send(3, changed).ready());
    internal::GlobalEngine::Release();
    EXPECT_EQ(seen, 1) << "it would have been executed by the GlobalEngine";
    EXPECT_TRUE(log.contains("'measure' cannot be sent") && log.contains("Unregistered")) << log.text();
}

TEST_F(OtherSignature, ResultWithoutDefaultValueIsRefusedWhenBinding) {
    c.addOperation("made", [](int n) { return WithoutDefault(n); });
    EXPECT_EQ(OperationCaller<WithoutDefault(int)>(part("made"))(3).number, 3);
    EXPECT_FALSE(OperationCaller<WithoutDefault(double)>(part("made")).ready());
    EXPECT_TRUE(log.contains("no default value")) << log.text();
}

TEST_F(OtherSignature, FailedConversionOfTheResultIsToldFromACallThatFailed) {
    static const bool added = (types_test::type("string")->addConstructor(new FailingConversion()), true);
    ASSERT_TRUE(added);
    c.addOperation("letter", [this] { return ++seen, 'x'; });
    OperationCaller<std::string()> letter(part("letter"), global);
    ASSERT_TRUE(letter.ready()) << log.text();
    try {
        letter();
        FAIL();
    } catch (const SendError& error) {
        FAIL() << error.what();
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("'letter' was executed"), std::string::npos) << error.what();
    }
    EXPECT_EQ(seen, 1);
    std::string result = "untouched";
    SendHandle<std::string()> handle = letter.send();
    EXPECT_EQ(handle.collect(result), CollectFailure);
    EXPECT_EQ(result, "untouched");
    EXPECT_EQ(seen, 2);
}

TEST_F(OtherSignature, MayBeBoundAnewByAMessageThatIsExecutedWhileItsCallWaits) {
    Probe client("client");
    OperationCaller<std::string(std::string)> greet;
    client.addOperation(
        "rebind", [&] { greet = part("greet"); }, OwnThread);
    client.addOperation(
        "go", [&](std::string name) { return greet(name); }, OwnThread);
    c.addOperation(
        "greet_late",
        [&](const std::string& name) {
            OperationCaller<void()>(client.getOperation("rebind"), c.engine())();
            return "good evening " + name;
        },
        OwnThread);
    ASSERT_TRUE(greet.setImplementationPart(part("greet_late"), client.engine()));
    OperationCaller<std::string(std::string)> go(client.getOperation("go"), global);
    EXPECT_EQ(go("whoever you are"), "good evening whoever you are");
    EXPECT_EQ(go("you"), "hello you");
}

TEST_F(OtherSignature, ExceptionsReachTheCallerAsTheyDoOtherwise) {
    OperationCaller<double(int)> bad(part("bad"), global), direct(part("refuse"), global);
    EXPECT_THROW(direct(1), std::logic_error);
    try {
        bad(1);
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("planted"), std::string::npos);
    }
    EXPECT_THROW(bad.send(1).collect(), std::runtime_error);
}

TEST_F(OtherSignature, CallersAreCopiedAssignedAndGivenAnEngine) {
    OperationCaller<int(double)> first = part("divide"), unbound;
    EXPECT_FALSE(first.ready()) << "three arguments";
    OperationCaller<double(int)> half = part("half"), copy(half), assigned;
    assigned = half;
    half.disconnect();
    EXPECT_FALSE(half.ready());
    EXPECT_EQ(copy(3), 1.5);
    EXPECT_EQ(assigned(3), 1.5);
    OperationCaller<double(int, int, int&)> divide = part("divide");
    int rest = 0;
    EXPECT_THROW(divide(7, 2, rest), SendError) << "no caller yet";
    divide.setCaller(global);
    EXPECT_EQ(divide(7, 2, rest), 3.0);
}

TEST_F(OtherSignature, OneCallerMayBeUsedWithinItself) {
    OperationCaller<double(int)> sum;
    c.addOperation("sum", [&](double n) -> double { return n <= 0 ? 0 : n + sum(static_cast<int>(n) - 1); });
    sum = part("sum");
    ASSERT_TRUE(sum.ready());
    EXPECT_EQ(sum(10), 55.0);
}

TEST_F(OtherSignature, IsNotReadyWhenTheComponentIsGone) {
    OperationCaller<double(int)> half;
    {
        Probe gone("gone");
        gone.addOperation("half", [](double x) { return x / 2; });
        half = gone.getOperation("half");
        ASSERT_TRUE(half.ready());
    }
    EXPECT_FALSE(half.ready());
    EXPECT_EQ(half(4), 0.0);
}

TEST_F(OtherSignature, RequestersBindToWhatCanBeConverted) {
    Probe client("client");
    OperationCaller<double(int)> half("half");
    OperationCaller<int(std::string)> twice("twice");
    client.requires_("numbers")->addOperationCaller(half);
    c.provides("numbers")->addOperation("half", [](double x) { return x / 2; });
    EXPECT_TRUE(client.connectServices(&c));
    EXPECT_EQ(half(3), 1.5);
}

}  // namespace
