// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Data sources, properties and operations that users write, as transports do for what lies in another process.
#include <rtt/OperationCaller.hpp>
#include <rtt/OperationInterfacePart.hpp>
#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/FusedFunctorDataSource.hpp>
#include <rtt/marsh/MarshallInterface.hpp>

#include <gtest/gtest.h>

using namespace RTT;

namespace {

typedef std::map<const base::DataSourceBase*, base::DataSourceBase*> Copies;

/** A value that is kept elsewhere, and written there when it was changed. */
class RegisterSource : public RTT::internal::AssignableDataSource<int> {
    int& register_;
    mutable int cached;

public:
    typedef boost::intrusive_ptr<RegisterSource> shared_ptr;
    RegisterSource(int& r) : register_(r), cached(0) {}
    bool evaluate() const override {
        cached = register_;
        return true;
    }
    int get() const override {
        evaluate();
        return cached;
    }
    int value() const override { return cached; }
    const int& rvalue() const override { return cached; }
    void set(internal::AssignableDataSource<int>::param_t v) override {
        cached = v;
        updated();
    }
    internal::AssignableDataSource<int>::reference_t set() override { return cached; }
    void updated() override { register_ = cached; }
    RegisterSource* clone() const override { return new RegisterSource(register_); }
    RegisterSource* copy(Copies&) const override { return const_cast<RegisterSource*>(this); }
};

/** The state of a call in another process. */
class RemoteStatus : public RTT::internal::DataSource<SendStatus> {
    SendStatus status;

public:
    RemoteStatus(SendStatus s) : status(s) {}
    bool evaluate() const override { return true; }
    SendStatus get() const override { return status; }
    SendStatus value() const override { return status; }
    const SendStatus& rvalue() const override { return status; }
    void reset() override { status = SendNotReady; }
    internal::DataSource<SendStatus>* clone() const override { return new RemoteStatus(status); }
    internal::DataSource<SendStatus>* copy(Copies&) const override { return const_cast<RemoteStatus*>(this); }
};

class Limited : public RTT::Property<double> {
    double most;

public:
    Limited(const std::string& name, double most) : Property<double>(name, "limited", 0.0), most(most) {}
    bool refresh(const base::PropertyBase* other) override {
        if (!Property<double>::refresh(other)) return false;
        if (get() > most) set(most);
        return true;
    }
    Limited* clone() const override { return new Limited(*this); }
};

struct Settings : public RTT::PropertyBag {
    Settings() : PropertyBag("Settings"), gain("gain", "of the controller", 2.0) { addProperty(gain); }
    Property<double> gain;
};

int sum(int a, int b) { return a + b; }

/** The sum of its arguments, as if it were computed elsewhere. */
class RemoteAdd : public RTT::OperationInterfacePart {
    std::string name;

public:
    RemoteAdd(const std::string& n) : name(n) {}
    std::string getName() const override { return name; }
    std::string description() const override { return "Adds."; }
    std::string resultType() const override { return "int"; }
    unsigned int arity() const override { return 2; }
    const types::TypeInfo* getArgumentType(unsigned int) const override {
        return internal::DataSourceTypeInfo<int>::getTypeInfo();
    }
    unsigned int collectArity() const override { return 1; }
    const types::TypeInfo* getCollectType(unsigned int) const override {
        return internal::DataSourceTypeInfo<int>::getTypeInfo();
    }
    std::vector<ArgumentDescription> getArgumentList() const override {
        std::vector<ArgumentDescription> list;
        list.push_back(ArgumentDescription("a", "first", "int"));
        list.push_back(ArgumentDescription("b", "second", "int"));
        return list;
    }
    base::DataSourceBase::shared_ptr produce(const std::vector<base::DataSourceBase::shared_ptr>& args,
                                             ExecutionEngine*) const override {
        if (args.size() != 2) throw wrong_number_of_args_exception(2, int(args.size()));
        base::DataSourceBase::shared_ptr result = internal::newFunctorDataSource(&sum, args);
        if (!result) throw wrong_types_of_args_exception(1, "int", args[0]->getType());
        return result;
    }
    base::DataSourceBase::shared_ptr produceSend(const std::vector<base::DataSourceBase::shared_ptr>&,
                                                 ExecutionEngine*) const override {
        return new RemoteStatus(SendSuccess);
    }
    base::DataSourceBase::shared_ptr produceHandle() const override { return new RemoteStatus(SendNotReady); }
    base::DataSourceBase::shared_ptr produceCollect(const std::vector<base::DataSourceBase::shared_ptr>&,
                                                    internal::DataSource<bool>::shared_ptr) const override {
        return new RemoteStatus(SendSuccess);
    }
    Handle produceSignal(base::ActionInterface*, const std::vector<base::DataSourceBase::shared_ptr>&,
                         ExecutionEngine*) const override {
        throw no_asynchronous_operation_exception("no signals from elsewhere");
    }
    boost::shared_ptr<base::DisposableInterface> getLocalOperation() const override {
        return boost::shared_ptr<base::DisposableInterface>();
    }
    bool isSynchronous() const override { return true; }
};

class NamesOnly : public RTT::marsh::MarshallInterface {
public:
    std::string text;
    void serialize(base::PropertyBase* property) override { text += property->getName() + ";"; }
    void serialize(const PropertyBag& bag) override {
        for (PropertyBag::const_iterator it = bag.begin(); it != bag.end(); ++it) serialize(*it);
    }
    void flush() override { text += "."; }
};

}  // namespace

TEST(UserCode, DerivesDataSources) {
    int elsewhere = 5;
    RegisterSource::shared_ptr source(new RegisterSource(elsewhere));
    EXPECT_EQ(source->get(), 5);
    source->set(6);
    EXPECT_EQ(elsewhere, 6);
    source->set() = 7;
    source->updated();
    EXPECT_EQ(elsewhere, 7);
    internal::AssignableDataSource<int>::shared_ptr typed = internal::AssignableDataSource<int>::narrow(source.get());
    EXPECT_TRUE(typed->isAssignable());
    Property<int> property("register", "elsewhere", typed);
    property.set(8);
    EXPECT_EQ(elsewhere, 8);
    internal::DataSource<int>::shared_ptr nine(new internal::ConstantDataSource<int>(9));
    EXPECT_TRUE(source->update(nine.get()));
    EXPECT_EQ(elsewhere, 9);

    internal::DataSource<SendStatus>::shared_ptr status(new RemoteStatus(SendSuccess));
    EXPECT_EQ(status->get(), SendSuccess);
    status->reset();
    EXPECT_EQ(status->get(), SendNotReady);
    EXPECT_EQ(status->getType(), "SendStatus");
}

TEST(UserCode, DerivesPropertiesAndBags) {
    Limited limited("limit", 10.0);
    Property<double> much("limit", "", 20.0);
    EXPECT_TRUE(limited.refresh(&much));
    EXPECT_EQ(limited.get(), 10.0);
    Settings settings;
    Property<double> gain = settings.getProperty("gain");
    ASSERT_TRUE(gain.ready());
    gain.set(3.0);
    EXPECT_EQ(settings.gain.get(), 3.0);
    NamesOnly names;
    names.serialize(settings);
    names.flush();
    EXPECT_EQ(names.text, "gain;.");
}

TEST(UserCode, DerivesAnOperationOfAnotherProcess) {
    TaskContext proxy("proxy");
    proxy.provides()->add("add", new RemoteAdd("add"));
    OperationInterfacePart* part = proxy.getOperation("add");
    ASSERT_TRUE(part);
    EXPECT_EQ(part->arity(), 2u);
    std::vector<base::DataSourceBase::shared_ptr> args(2, new internal::ConstantDataSource<int>(4));
    base::DataSourceBase::shared_ptr result = part->produce(args, 0);
    EXPECT_EQ(internal::DataSource<int>::narrow(result.get())->get(), 8);
    EXPECT_THROW(part->produce(std::vector<base::DataSourceBase::shared_ptr>(), 0), wrong_number_of_args_exception);
    OperationCaller<int(int, int)> add(part, proxy.engine());
    ASSERT_TRUE(add.ready());
    EXPECT_EQ(add(2, 3), 5);
    EXPECT_EQ(add(4, 5), 9);
}
