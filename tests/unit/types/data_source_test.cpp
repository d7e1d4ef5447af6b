// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/DataSourceGenerator.hpp>
#include <rtt/internal/DataSourceCommand.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/FusedFunctorDataSource.hpp>
#include <rtt/internal/PartDataSource.hpp>
#include <rtt/types/Types.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <thread>

using namespace RTT;
using namespace RTT::internal;
using SourcePtr = base::DataSourceBase::shared_ptr;

namespace {

struct Unregistered {
    int number = 0;
};

struct Pair {
    double first = 1, second = 2;
};

struct CountsDeletes : ValueDataSource<int> {
    explicit CountsDeletes(int& deleted) : deleted_(deleted) {}
    ~CountsDeletes() override { ++deleted_; }
    int& deleted_;
};

}  // namespace

TEST(DataSource, LastReferenceDeletesIt) {
    int deleted = 0;
    {
        SourcePtr first(new CountsDeletes(deleted));
        SourcePtr second = first;
        first.reset();
        EXPECT_EQ(0, deleted);
    }
    EXPECT_EQ(1, deleted);
}

TEST(DataSource, ValueIsReadAndSet) {
    ValueDataSource<int>::shared_ptr source(new ValueDataSource<int>(3));
    EXPECT_EQ(3, source->get());
    source->set(4);
    EXPECT_EQ(4, source->rvalue());
    source->set() = 5;
    EXPECT_EQ(5, source->value());
    EXPECT_TRUE(source->isAssignable());
}

TEST(DataSource, UpdateTakesTheSameTypeOnly) {
    ValueDataSource<Unregistered>::shared_ptr a(new ValueDataSource<Unregistered>()),
        b(new ValueDataSource<Unregistered>());
    b->set().number = 9;
    EXPECT_TRUE(a->update(b.get()));
    EXPECT_EQ(9, a->rvalue().number);
    EXPECT_FALSE(a->update(SourcePtr(new ValueDataSource<int>(1)).get()));
    EXPECT_FALSE(a->update(nullptr));
}

TEST(DataSource, UpdateTakesResultsThatAreReferences) {
    ValueDataSource<std::string>::shared_ptr target(new ValueDataSource<std::string>());
    const std::string text = "hello";
    SourcePtr reference(newFunctorDataSource(
        +[](const std::string& t) -> const std::string& { return t; },
        GenerateDataSource()(new ConstantDataSource<std::string>(text))));
    ASSERT_TRUE(reference);
    EXPECT_TRUE(target->update(reference.get()));
    EXPECT_EQ("hello", target->get());
}

TEST(DataSource, ConstantsRefuseUpdates) {
    SourcePtr constant(new ConstantDataSource<int>(3));
    EXPECT_FALSE(constant->isAssignable());
    EXPECT_FALSE(constant->update(SourcePtr(new ValueDataSource<int>(4)).get()));
    EXPECT_THROW(constant->updateAction(SourcePtr(new ValueDataSource<int>(4)).get()), bad_assignment);
}

TEST(DataSource, ReferenceChangesTheVariable) {
    double variable = 1;
    ReferenceDataSource<double>::shared_ptr source(new ReferenceDataSource<double>(variable));
    source->set(2);
    EXPECT_EQ(2, variable);
    variable = 3;
    EXPECT_EQ(3, source->get());
    EXPECT_EQ(&variable, source->getRawPointer());
}

TEST(DataSource, UpdateActionAssignsWhenExecuted) {
    ValueDataSource<int>::shared_ptr left(new ValueDataSource<int>(1)), right(new ValueDataSource<int>(2));
    const std::unique_ptr<base::ActionInterface> action(left->updateAction(right.get()));
    EXPECT_EQ(1, left->get());
    action->readArguments();
    right->set(3);  // the value read before is not kept: the source itself is the storage
    EXPECT_TRUE(action->execute());
    EXPECT_EQ(3, left->get());
    EXPECT_FALSE(action->execute()) << "arguments must be read again";
}

TEST(DataSource, AssignCommandOfOneTypeParameter) {
    ValueDataSource<int>::shared_ptr left(new ValueDataSource<int>(1)), right(new ValueDataSource<int>(2));
    AssignCommand<int> command(left, right);
    command.readArguments();
    EXPECT_TRUE(command.execute());
    EXPECT_EQ(2, left->get());
}

TEST(DataSource, CopySharesVariablesButNotLocalOnes) {
    CopyMap copies;
    ValueDataSource<int>::shared_ptr shared(new ValueDataSource<int>(1));
    EXPECT_EQ(shared.get(), shared->copy(copies));
    typedef UnboundDataSource<ValueDataSource<int>> Local;
    boost::intrusive_ptr<Local> local(new Local(5));
    AssignableDataSource<int>::shared_ptr copied(local->copy(copies));
    EXPECT_NE(static_cast<base::DataSourceBase*>(local.get()), copied.get());
    EXPECT_EQ(copied.get(), local->copy(copies)) << "within one copy the same local stays the same";
    copied->set(6);
    EXPECT_EQ(5, local->get());
}

TEST(DataSource, PartKeepsItsParentAlive) {
    ValueDataSource<Pair>::shared_ptr parent(new ValueDataSource<Pair>());
    AssignableDataSource<double>::shared_ptr part(new PartDataSource<double>(parent->set().second, parent));
    const void* where = parent->getRawConstPointer();
    parent.reset();
    part->set(8);
    EXPECT_EQ(8, static_cast<const Pair*>(where)->second);
    EXPECT_EQ(where, part->getParent()->getRawConstPointer());
}

TEST(DataSource, CopyOfAPartIsAPartOfTheCopy) {
    typedef UnboundDataSource<ValueDataSource<Pair>> Local;
    boost::intrusive_ptr<Local> parent(new Local());
    AssignableDataSource<double>::shared_ptr part(new PartDataSource<double>(parent->set().second, parent));
    CopyMap copies;
    AssignableDataSource<double>::shared_ptr copied(part->copy(copies));
    copied->set(7);
    EXPECT_EQ(2, parent->rvalue().second);
    EXPECT_EQ(7, static_cast<const Pair*>(copied->getParent()->getRawConstPointer())->second);
}

TEST(DataSource, ArrayOwnsItsElements) {
    ArrayDataSource<types::carray<int>> source(3);
    source.set()[2] = 5;
    EXPECT_EQ(5, source.rvalue()[2]);
    EXPECT_EQ(3u, source.rvalue().count());
}

TEST(DataSource, TypeOfUnregisteredValuesIsUnknown) {
    EXPECT_EQ("unknown_t", DataSource<Unregistered>::GetTypeInfo()->getTypeName());
    EXPECT_EQ("unknown_t const&", DataSource<const Unregistered&>::GetType());
    EXPECT_EQ("unknown_t &", DataSource<Unregistered&>::GetType());
    SourcePtr source(new ValueDataSource<Unregistered>());
    EXPECT_EQ("(unknown_t)", source->toString());
}

TEST(FunctorSource, CallsTheFunctionAnewEachTime) {
    ValueDataSource<int>::shared_ptr a(new ValueDataSource<int>(1)), b(new ValueDataSource<int>(2));
    SourcePtr sum(newFunctorDataSource(std::plus<int>(), GenerateDataSource()(a.get(), b.get())));
    auto* typed = DataSource<int>::narrow(sum.get());
    ASSERT_NE(nullptr, typed);
    EXPECT_EQ(3, typed->get());
    a->set(5);
    EXPECT_EQ(7, typed->get());
    EXPECT_EQ(7, typed->rvalue());
}

TEST(FunctorSource, ReferenceResultsCanBeAssigned) {
    ValueDataSource<std::vector<double>>::shared_ptr v(
        new ValueDataSource<std::vector<double>>(std::vector<double>(3)));
    ValueDataSource<int>::shared_ptr index(new ValueDataSource<int>(1));
    SourcePtr item(newFunctorDataSource(
        +[](std::vector<double>& c, int i) -> double& { return c[i]; }, GenerateDataSource()(v.get(), index.get())));
    auto* typed = AssignableDataSource<double>::narrow(item.get());
    ASSERT_NE(nullptr, typed);
    typed->set(4.5);
    EXPECT_EQ(4.5, v->rvalue()[1]);
    index->set(2);
    EXPECT_EQ(0, typed->get());
}

TEST(FunctorSource, WrongArgumentsGiveNull) {
    SourcePtr number(new ValueDataSource<int>(1)), text(new ValueDataSource<std::string>());
    EXPECT_EQ(nullptr, newFunctorDataSource(std::plus<int>(), GenerateDataSource()(number.get())));
    EXPECT_EQ(nullptr, newFunctorDataSource(std::plus<int>(), GenerateDataSource()(number.get(), text.get())));
    SourcePtr constant(new ConstantDataSource<int>(1));
    EXPECT_EQ(nullptr, newFunctorDataSource(
                           +[](int& i) { return i; }, GenerateDataSource()(constant.get())));
}

TEST(FunctorSource, FunctionsWithoutResultAreCalled) {
    ValueDataSource<int>::shared_ptr number(new ValueDataSource<int>(1));
    SourcePtr call(newFunctorDataSource(
        +[](int& i) { ++i; }, GenerateDataSource()(number.get())));
    ASSERT_TRUE(call);
    EXPECT_TRUE(call->evaluate());
    EXPECT_EQ(2, number->get());
}

TEST(DataSource, CommandEvaluatesItsSource) {
    ValueDataSource<int>::shared_ptr number(new ValueDataSource<int>(1));
    DataSourceCommand count(newFunctorDataSource(
        +[](int& i) { return ++i < 3; }, GenerateDataSource()(number.get())));
    count.readArguments();
    EXPECT_EQ(1, number->get());
    EXPECT_TRUE(count.execute());
    EXPECT_FALSE(count.execute()) << "the function says so";
    EXPECT_EQ(3, number->get());
}

TEST(DataSource, ActionAliasRunsItsActionFirst) {
    ValueDataSource<int>::shared_ptr number(new ValueDataSource<int>(1)), copy(new ValueDataSource<int>(0));
    SourcePtr alias(new ActionAliasAssignableDataSource<int>(new AssignCommand<int>(copy, number), copy.get()));
    auto* typed = AssignableDataSource<int>::narrow(alias.get());
    ASSERT_NE(nullptr, typed);
    EXPECT_EQ(1, typed->get());
    number->set(5);
    EXPECT_TRUE(alias->evaluate());
    EXPECT_EQ(5, typed->value());
    typed->set(7);
    EXPECT_EQ(7, copy->get());
}

TEST(DataSource, ReferencesAreCountedAcrossThreads) {
    int deleted = 0;
    {
        SourcePtr source(new CountsDeletes(deleted));
        auto use = [source] {
            for (int i = 0; i != 20000; ++i) SourcePtr copy = source;
        };
        std::thread a(use), b(use);
        a.join();
        b.join();
        EXPECT_EQ(0, deleted);
    }
    EXPECT_EQ(1, deleted);
}
