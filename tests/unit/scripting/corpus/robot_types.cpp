// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "robot.hpp"

#include <rtt/internal/GlobalService.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/types/EnumTypeInfo.hpp>
#include <rtt/types/GlobalsRepository.hpp>
#include <rtt/types/OperatorTypes.hpp>
#include <rtt/types/Operators.hpp>
#include <rtt/types/SequenceTypeInfo.hpp>
#include <rtt/types/StructTypeInfo.hpp>
#include <rtt/types/TemplateConstructor.hpp>
#include <rtt/types/Types.hpp>

#include <boost/serialization/serialization.hpp>
#include <gtest/gtest.h>

namespace scripting_corpus {

struct Point {
    double x = 0, y = 0;
};
/** Its array is of a type that nobody registers. */
struct Spread {
    short values[2] = {};
};
enum Colour { Red = 1, Green = 2 };

}  // namespace scripting_corpus

namespace boost::serialization {

template <class Archive>
void serialize(Archive& archive, scripting_corpus::Point& point, unsigned int) {
    archive& make_nvp("x", point.x);
    archive& make_nvp("y", point.y);
}

template <class Archive>
void serialize(Archive& archive, scripting_corpus::Spread& spread, unsigned int) {
    archive& make_nvp("values", spread.values);
}

}  // namespace boost::serialization

namespace scripting_corpus {

using namespace RTT;

namespace {

Point pointOf(double x, double y) { return {x, y}; }

struct Sum {
    typedef Point first_argument_type;
    typedef Point second_argument_type;
    typedef Point result_type;
    Point operator()(const Point& a, const Point& b) const { return {a.x + b.x, a.y + b.y}; }
};
struct Scaled {
    typedef Point first_argument_type;
    typedef double second_argument_type;
    typedef Point result_type;
    Point operator()(const Point& a, double by) const { return {a.x * by, a.y * by}; }
};
struct Opposite {
    typedef Point argument_type;
    typedef Point result_type;
    Point operator()(const Point& a) const { return {-a.x, -a.y}; }
};

struct ColourInfo : types::EnumTypeInfo<Colour> {
    ColourInfo() : types::EnumTypeInfo<Colour>("Colour") {
        to_string[Red] = "red";
        to_string[Green] = "green";
    }
};

void addTypes() {
    types::Types()->addType(new types::SequenceTypeInfo<std::vector<std::string>>("strings"));
    types::Types()->addType(new types::SequenceTypeInfo<std::vector<int>>("ints"));
    types::Types()->addType(new types::StructTypeInfo<Point>("geo.Point"));
    types::Types()->addType(new types::StructTypeInfo<Spread>("geo.Spread"));
    types::Types()->type("geo.Point")->addConstructor(types::newConstructor(&pointOf));
    types::Types()->addType(new types::SequenceTypeInfo<std::vector<Point>>("/geo/Path"));
    types::Types()->addType(new types::SequenceTypeInfo<std::vector<float>>("vector<float>"));
    types::Types()->addType(new ColourInfo);
    types::operators()->add(types::newBinaryOperator("+", Sum()));
    types::operators()->add(types::newBinaryOperator("*", Scaled()));
    types::operators()->add(types::newUnaryOperator("-", Opposite()));
    types::GlobalsRepository::Instance()->setValue(new Constant<Colour>("Green", Green));
}

}  // namespace

void loadTypesAndScripting() {
    static const bool once = [] {
        const auto loader = plugin::PluginLoader::Instance();
        EXPECT_TRUE(loader->loadLibrary(RTT_TYPEKIT_FILE));
        EXPECT_TRUE(loader->loadLibrary(RTT_SCRIPTING_FILE));
        addTypes();
        const Service::shared_ptr texts = internal::GlobalService::Instance()->provides("texts");
        texts->addOperation("length", [](const std::string& text) { return static_cast<int>(text.size()); });
        return true;
    }();
    (void)once;
}

}  // namespace scripting_corpus
