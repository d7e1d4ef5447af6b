// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A typekit for linear algebra is loaded unchanged, and its operators, members, constructors and bags are used.
#include "linear/linear.hpp"
#include "loaded_typekit.hpp"

#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/types/PropertyDecomposition.hpp>

using namespace RTT;
using namespace types_test;
using linear::Matrix;
using linear::Vector;

namespace {

class LinearTypekit : public WithLoadedTypekit {
protected:
    static SourcePtr vector(std::vector<double> values) { return make("linear_vector", {variable(values)}); }
};

}  // namespace

TEST_F(LinearTypekit, ConstructorsOfAllStyles) {
    EXPECT_EQ("1.5 1.5", textOf(make("linear_vector", {variable(2), variable(1.5)})));
    EXPECT_EQ("3 3", textOf(make("linear_vector", {variable(2), variable(3)}))) << "the int is converted";
    EXPECT_EQ("1 2 4", textOf(vector({1, 2, 4})));
    EXPECT_EQ("0 0; 0 0; 0 0", textOf(make("linear_matrix", {variable(3), variable(2)})));
    const SourcePtr square = make("linear_matrix", {variable(1.), variable(2.), variable(3.), variable(4.)});
    EXPECT_EQ("1 2; 3 4", textOf(square)) << "four arguments";
    EXPECT_EQ("1 2; 9 4", textOf(make("linear_matrix", {square, variable(2), variable(9.)}))) << "a ternary function";
    EXPECT_EQ("", textOf(make("linear_vector", {})));
    EXPECT_EQ(nullptr, make("linear_vector", {variable("text")}));
    EXPECT_EQ("2.5", textOf(make("string", {variable(2.5)}))) << "by lexical_cast";
}

TEST_F(LinearTypekit, ConstructedValuesFollowTheirArguments) {
    const auto size = variable(1);
    const SourcePtr made = make("linear_vector", {size, variable(1.0)});
    EXPECT_EQ("1", textOf(made));
    size->set(3);
    EXPECT_EQ("1 1 1", textOf(made));
}

TEST_F(LinearTypekit, AutomaticConversion) {
    const SourcePtr converted = type("linear_vector")->convert(variable(std::vector<double>{1, 2}));
    EXPECT_EQ("1 2", textOf(converted));
    const auto target = variable(Vector(1));
    const std::unique_ptr<base::ActionInterface> assign(target->updateAction(variable(std::vector<double>{5}).get()));
    assign->readArguments();
    EXPECT_TRUE(assign->execute());
    EXPECT_EQ("5", textOf(target));
}

TEST_F(LinearTypekit, Operators) {
    const SourcePtr a = vector({1, 2}), b = vector({10, 20});
    EXPECT_EQ("11 22", textOf(binary("+", a, b)));
    EXPECT_EQ("-1 -2", textOf(unary("-", a)));
    EXPECT_EQ("2 4", textOf(binary("*", a, variable(2.0))));
    EXPECT_EQ("2 4", textOf(binary("*", a, variable(2)))) << "the factor is converted";
    EXPECT_EQ("2 4", textOf(binary("*", variable(2.0), a)));
    EXPECT_EQ("5 10", textOf(binary("/", b, variable(2.0))));
    EXPECT_EQ(50, valueOf<double>(binary("*", a, b))) << "exactly these types go first";
    const SourcePtr matrix = make("linear_matrix", {variable(1.), variable(2.), variable(3.), variable(4.)});
    EXPECT_EQ("50 110", textOf(binary("*", matrix, b)));
    EXPECT_EQ(nullptr, binary("+", a, matrix));
    EXPECT_EQ(nullptr, binary("-", a, b));
}

TEST_F(LinearTypekit, MembersOfTheMixin) {
    const auto v = variable(Vector(2));
    EXPECT_EQ((std::vector<std::string>{"size", "capacity"}), v->getMemberNames());
    EXPECT_EQ(2, valueOf<int>(v->getMember("size")));
    ASSERT_TRUE(v->getMember("1")->update(variable(4.5).get()));
    EXPECT_EQ("0 4.5", textOf(v));
    ASSERT_TRUE(v->getMember(variable(0))->update(variable(1.5).get()));
    EXPECT_EQ("1.5 4.5", textOf(v));
    EXPECT_EQ(0, valueOf<double>(v->getMember(variable(7)))) << "beyond the end";
    EXPECT_EQ(nullptr, v->getMember("no such member"));
    const SourcePtr constant(new internal::ConstantDataSource<Vector>(v->get()));
    EXPECT_EQ(4.5, valueOf<double>(constant->getMember(variable(1))));
    EXPECT_FALSE(constant->getMember(variable(1))->isAssignable());
    const SourcePtr m = make("linear_matrix", {variable(1.), variable(2.), variable(3.), variable(4.)});
    EXPECT_EQ("3 4", textOf(m->getMember(variable(1)))) << "a row";
    EXPECT_EQ("3 4", textOf(m->getMember(variable(1u)))) << "the index is converted";
    EXPECT_EQ(2, valueOf<int>(m->getMember("cols")));
}

TEST_F(LinearTypekit, Resize) {
    const auto v = variable(Vector(1));
    EXPECT_TRUE(type("linear_vector")->resize(v, 3));
    EXPECT_EQ("0 0 0", textOf(v));
    EXPECT_FALSE(type("linear_matrix")->resize(type("linear_matrix")->buildValue(), 3));
}

TEST_F(LinearTypekit, BagsByTheImplFunctionsAlone) {
    PropertyBag bag;
    ASSERT_TRUE(types::typeDecomposition(vector({4, 5}), bag));
    EXPECT_EQ("linear_vector", bag.getType());
    ASSERT_EQ(2u, bag.size());
    EXPECT_EQ("2", bag.getItem(1)->getName());
    Property<Vector> property("v", "");
    EXPECT_TRUE(property.compose(bag));
    EXPECT_EQ(5, property.rvalue()(1));
    bag.setType("another");
    EXPECT_FALSE(property.compose(bag));
}

TEST_F(LinearTypekit, FileRoundTrip) {
    Vector vector(3);
    vector(0) = 0.1, vector(2) = -7e200;
    EXPECT_EQ("0.1 0 -7e+200", textOf(variable(throughFile(vector))));
    Matrix matrix(2, 3);
    matrix(0, 1) = 2, matrix(1, 2) = 0.25;
    EXPECT_EQ("0 2 0; 0 0 0.25", textOf(variable(throughFile(matrix))));
}

TEST_F(LinearTypekit, TravelsThroughPorts) {
    const std::unique_ptr<base::OutputPortInterface> out(type("linear_vector")->outputPort("out"));
    const std::unique_ptr<base::InputPortInterface> in(type("linear_vector")->inputPort("in"));
    ASSERT_TRUE(out && in && out->connectTo(in.get()));
    EXPECT_EQ(WriteSuccess, out->write(vector({1, 2})));
    const SourcePtr received = type("linear_vector")->buildValue();
    EXPECT_EQ(NewData, in->read(received));
    EXPECT_EQ("1 2", textOf(received));
}
