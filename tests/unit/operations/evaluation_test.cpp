// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Generic calls whose arguments cannot be evaluated (a division by zero, a conversion that does not fit), and the results
// of generic calls that did not take place.
#include "probe.hpp"

#include <rtt/FactoryExceptions.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/FusedFunctorDataSource.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/OperationCallerC.hpp>

using namespace RTT;
using namespace RTT::internal;
using oroforge::test::Probe;

namespace {

typedef base::DataSourceBase::shared_ptr Source;

/** An argument whose evaluation fails when it is told to. */
struct Fragile : DataSource<int> {
    bool works = false;
    int number = 7;

    bool evaluate() const override { return works; }
    int get() const override { return number; }
    int value() const override { return number; }
    const int& rvalue() const override { return number; }
    Fragile* clone() const override { return new Fragile; }
    Fragile* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>&) const override {
        return const_cast<Fragile*>(this);
    }
};

struct Evaluation : testing::Test {
    Probe c{"server"};
    ExecutionEngine* global = GlobalEngine::Instance();
    boost::intrusive_ptr<Fragile> fragile{new Fragile};
    std::atomic<int> calls{0};

    Evaluation() {
        c.addOperation("twice", [this](int n) { return ++calls, 2 * n; });
        c.addOperation(
            "own_twice", [this](int n) { return ++calls, 2 * n; }, OwnThread);
        c.addOperation("nothing", [this](int) { ++calls; });
        c.addOperation("change", [this](int, int& out) { ++calls, out = 1; });
        c.addOperation("word", [](bool fails) -> std::string {
            if (fails) throw std::runtime_error("planted");
            return "a word that is long enough not to be stored in place";
        });
        c.addOperation("referred", [this]() -> int& { return kept; });
    }
    OperationInterfacePart* part(const char* name) { return c.getOperation(name); }
    int kept = 5;
};

TEST_F(Evaluation, OperationIsNotCalledIfAnArgumentFails) {
    for (const char* name : {"twice", "own_twice", "nothing"}) {
        Source source = part(name)->produce({fragile}, global);
        fragile->works = false;
        EXPECT_FALSE(source->evaluate()) << name;
        EXPECT_EQ(calls, 0) << name;
        fragile->works = true;
        EXPECT_TRUE(source->evaluate()) << name;
        EXPECT_EQ(calls, 1) << name;
        calls = 0;
    }
}

TEST_F(Evaluation, GetSaysWhichArgumentFailed) {
    Source source = part("twice")->produce({fragile}, global);
    auto* twice = DataSource<int>::narrow(source.get());
    ASSERT_TRUE(twice);
    try {
        twice->get();
        FAIL() << "gave a value";
    } catch (const std::runtime_error& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("'twice'"), std::string::npos) << text;
        EXPECT_NE(text.find("argument 1"), std::string::npos) << text;
    }
    EXPECT_EQ(calls, 0);
}

TEST_F(Evaluation, FailureOfAnInnerCallIsThatOfTheOuterOne) {
    Source inner = part("twice")->produce({fragile}, global);
    Source outer = part("twice")->produce({inner}, global);
    EXPECT_FALSE(outer->evaluate());
    EXPECT_EQ(calls, 0);
    fragile->works = true;
    EXPECT_EQ(DataSource<int>::narrow(outer.get())->get(), 28);
}

TEST_F(Evaluation, OutputsAreLeftAlone) {
    ValueDataSource<int>::shared_ptr out(new ValueDataSource<int>(3));
    Source source = part("change")->produce({fragile, out}, global);
    EXPECT_FALSE(source->evaluate());
    EXPECT_EQ(out->get(), 3);
}

TEST_F(Evaluation, OperationIsNotSentIfAnArgumentFails) {
    Source handle = part("own_twice")->produceHandle();
    Source sending = part("own_twice")->produceSend({fragile}, global);
    EXPECT_FALSE(sending->evaluate());
    EXPECT_FALSE(handle->update(sending.get()));
    fragile->works = true;
    ASSERT_TRUE(handle->update(sending.get()));
    Source collecting = part("own_twice")->produceCollect({handle}, new ConstantDataSource<bool>(true));
    EXPECT_EQ(DataSource<SendStatus>::narrow(collecting.get())->get(), SendSuccess);
    EXPECT_EQ(calls, 1);
}

TEST_F(Evaluation, CallerCIsToldOfTheFailure) {
    int result = 3;
    OperationCallerC twice(part("twice"), "twice", global);
    twice.arg(Source(fragile)).ret(result);
    EXPECT_FALSE(twice.call());
    EXPECT_EQ(result, 3);
    OperationCallerC own(part("own_twice"), "own_twice", global);
    own.arg(Source(fragile));
    EXPECT_FALSE(own.send().ready());
    EXPECT_EQ(calls, 0);
    fragile->works = true;
    EXPECT_TRUE(twice.call());
    EXPECT_EQ(result, 14);
}

TEST_F(Evaluation, FunctionsOfTypesAreNotCalledEither) {
    int called = 0;
    Source sum(newFunctorDataSource(std::function<int(int)>([&](int n) { return ++called, n; }), {fragile}));
    ASSERT_TRUE(sum);
    EXPECT_FALSE(sum->evaluate());
    EXPECT_EQ(called, 0);
    fragile->works = true;
    EXPECT_TRUE(sum->evaluate());
    EXPECT_EQ(called, 1);
}

TEST_F(Evaluation, ResultIsADefaultValueBeforeTheFirstCall) {
    Source word = part("word")->produce({new ConstantDataSource<bool>(false)}, nullptr);
    EXPECT_EQ(DataSource<std::string>::narrow(word.get())->value(), "");
    EXPECT_EQ(DataSource<std::string>::narrow(word.get())->rvalue(), "");
    Source referred = part("referred")->produce({}, nullptr);
    EXPECT_EQ(DataSource<int&>::narrow(referred.get())->value(), 0);
    EXPECT_EQ(DataSource<int&>::narrow(referred.get())->get(), 5);
    EXPECT_EQ(&DataSource<int&>::narrow(referred.get())->value(), &kept);
}

TEST_F(Evaluation, ResultIsADefaultValueAfterTheOperationThrew) {
    ValueDataSource<bool>::shared_ptr fails(new ValueDataSource<bool>(false));
    Source source = part("word")->produce({fails}, nullptr);
    auto* word = DataSource<std::string>::narrow(source.get());
    EXPECT_EQ(word->get().substr(0, 6), "a word");
    fails->set(true);
    EXPECT_THROW(word->evaluate(), std::runtime_error);
    EXPECT_EQ(word->value(), "");
    fails->set(false);
    EXPECT_TRUE(word->evaluate());
    EXPECT_EQ(word->value().substr(0, 6), "a word");
}

TEST_F(Evaluation, CallerCOutlivesTheRegistration) {
    int result = 0;
    OperationCallerC twice(part("twice"), "twice", global);
    twice.argC(2).ret(result);
    c.provides()->removeOperation("twice");
    EXPECT_TRUE(twice.ready());
    EXPECT_TRUE(twice.call());
    EXPECT_EQ(result, 4);
}

TEST_F(Evaluation, HandleCOutlivesTheRegistration) {
    int result = 0;
    SendHandleC handle = OperationCallerC(part("own_twice"), "own_twice", global).argC(4).send();
    c.addOperation("own_twice", [](const std::string&) {});  // replaces it
    {
        SendHandleC collecting = handle;
        collecting.setAutoCollect(true);
    }
    handle.arg(result);
    EXPECT_EQ(handle.collect(), SendSuccess);
    EXPECT_EQ(result, 8);
}

}  // namespace
