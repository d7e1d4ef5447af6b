// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A hand-written typekit is loaded beside the built-in one and its operators, members, constructors and bags are used.
#include "vector_types.hpp"

#include <rtt/Property.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/types/Operators.hpp>
#include <rtt/types/PropertyDecomposition.hpp>
#include <rtt/types/Types.hpp>

#include <gtest/gtest.h>

#include <dlfcn.h>
#include <memory>

using namespace RTT;
using algebra::Joint;
using algebra::Vector;
using SourcePtr = base::DataSourceBase::shared_ptr;

namespace {

void loadPlugin(const char* file) {
    void* library = dlopen(file, RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(nullptr, library) << dlerror();
    using Load = bool(RTT::TaskContext*);
    auto* load = reinterpret_cast<Load*>(dlsym(library, "loadRTTPlugin"));
    ASSERT_NE(nullptr, load);
    ASSERT_TRUE(load(nullptr));
}

template <class T>
SourcePtr variable(T value) {
    return new internal::ValueDataSource<T>(value);
}

template <class T>
T valueOf(const SourcePtr& source) {
    auto* typed = internal::DataSource<T>::narrow(source.get());
    EXPECT_NE(nullptr, typed);
    return typed ? typed->get() : T();
}

class HandwrittenTypekit : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        loadPlugin(RTT_TYPEKIT_FILE);
        loadPlugin(TYPEKIT_FILE);
    }
    types::TypeInfo* type(const char* name) { return types::Types()->type(name); }
    SourcePtr make(std::vector<SourcePtr> arguments) { return type("algebra_vector")->construct(arguments); }
};

}  // namespace

TEST_F(HandwrittenTypekit, ConstructorsOfAllStyles) {
    EXPECT_EQ("0 0", make({variable(2)})->toString());
    EXPECT_EQ("1.5 1.5", make({variable(2), variable(1.5)})->toString());
    EXPECT_EQ("1 2 3", make({variable(1.0), variable(2.0), variable(3.0)})->toString());
    EXPECT_EQ("1 2 3", make({variable(1), variable(2), variable(3)})->toString()) << "integers are converted";
    EXPECT_EQ(nullptr, make({variable(std::string("x"))}));
}

TEST_F(HandwrittenTypekit, Operators) {
    const SourcePtr a = make({variable(2), variable(1.0)}), b = make({variable(2), variable(-2.5)});
    const SourcePtr sum(types::operators()->applyBinary("+", a.get(), b.get()));
    ASSERT_TRUE(sum);
    EXPECT_EQ("-1.5 -1.5", sum->toString());
    const SourcePtr norm(types::operators()->applyUnary("norm1", sum.get()));
    EXPECT_EQ(3.0, valueOf<double>(norm));
}

TEST_F(HandwrittenTypekit, MembersOfTheMixin) {
    const SourcePtr v = variable(Vector(2));
    EXPECT_EQ(2, valueOf<int>(v->getMember("size")));
    const SourcePtr second = v->getMember(variable(1));
    ASSERT_TRUE(second && second->update(variable(4.5).get()));
    EXPECT_EQ("0 4.5", v->toString());
    EXPECT_TRUE(v->getTypeInfo()->resize(v, 3));
    EXPECT_EQ(3, valueOf<int>(v->getMember("size")));
    EXPECT_EQ(4.5, valueOf<double>(v->getMember(variable(1u)))) << "the index is converted";
}

TEST_F(HandwrittenTypekit, CompositionOfTheMixin) {
    const SourcePtr v = make({variable(2), variable(0.5)});
    PropertyBag bag;
    ASSERT_TRUE(types::typeDecomposition(v, bag));
    EXPECT_EQ("algebra_vector", bag.getType());
    EXPECT_EQ(2u, bag.size());
    Property<Vector> property("v", "");
    EXPECT_TRUE(property.compose(bag));
    EXPECT_EQ(0.5, property.get()(1));
    PropertyBag wrong;
    wrong.ownProperty(new Property<std::string>("Element0", "", "x"));
    EXPECT_FALSE(property.compose(wrong));
}

TEST_F(HandwrittenTypekit, SerializedStructHasLiveMembers) {
    internal::ValueDataSource<Joint>::shared_ptr joint(new internal::ValueDataSource<Joint>());
    EXPECT_EQ((std::vector<std::string>{"name", "position", "limits", "torque"}), joint->getMemberNames());
    ASSERT_TRUE(joint->getMember("position")->update(variable(2.5).get()));
    EXPECT_EQ(2.5, joint->rvalue().position);
    ASSERT_TRUE(joint->getMember("limits.1")->update(variable(9.0).get()));
    EXPECT_EQ(9, joint->rvalue().limits[1]);
    joint->set().torque = Vector(2);
    EXPECT_EQ("{name = , position = 2.5, limits = {-1, 9}, torque = 0 0}", joint->toString());
}

TEST_F(HandwrittenTypekit, SerializedStructRoundTripsThroughABag) {
    internal::ValueDataSource<Joint>::shared_ptr joint(new internal::ValueDataSource<Joint>()),
        other(new internal::ValueDataSource<Joint>());
    joint->set().name = "elbow";
    joint->set().limits[0] = -3;
    joint->set().torque = Vector(1);
    PropertyBag bag;
    ASSERT_TRUE(types::typeDecomposition(joint, bag));
    ASSERT_TRUE(joint->getTypeInfo()->composeType(new internal::ValueDataSource<PropertyBag>(bag), other));
    EXPECT_EQ(joint->toString(), other->toString());
}

TEST_F(HandwrittenTypekit, SequenceOfSerializedStructs) {
    SourcePtr joints = type("algebra_joints")->buildValue();
    ASSERT_TRUE(type("algebra_joints")->resize(joints, 2));
    ASSERT_TRUE(joints->getMember("1.name")->update(variable(std::string("wrist")).get()));
    EXPECT_EQ("wrist", valueOf<std::string>(joints->getMember("1.name")));
}

TEST_F(HandwrittenTypekit, TypesTravelThroughPorts) {
    for (const char* name : {"algebra_vector", "algebra_joint", "algebra_joints"}) {
        const std::unique_ptr<base::OutputPortInterface> out(type(name)->outputPort("out"));
        const std::unique_ptr<base::InputPortInterface> in(type(name)->inputPort("in"));
        ASSERT_TRUE(out && in) << name;
        EXPECT_TRUE(out->connectTo(in.get())) << name;
    }
}
