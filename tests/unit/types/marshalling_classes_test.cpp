// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The classes of rtt/marsh as programs use them.
#include "cpf_fixture.hpp"

#include <rtt/TaskContext.hpp>
#include <rtt/marsh/CPFDemarshaller.hpp>
#include <rtt/marsh/CPFMarshaller.hpp>
#include <rtt/marsh/PropertyLoader.hpp>
#include <rtt/marsh/PropertyMarshaller.hpp>
#include <rtt/marsh/TinyDemarshaller.hpp>

using namespace RTT;
using namespace types_test;

namespace {

/** As users write their own formats. */
class NamesMarshaller : public marsh::MarshallInterface, public marsh::StreamProcessor<std::ostream> {
public:
    explicit NamesMarshaller(std::ostream& stream) : marsh::StreamProcessor<std::ostream>(stream) {}
    void serialize(base::PropertyBase* property) override {
        auto* bag = dynamic_cast<Property<PropertyBag>*>(property);
        bag ? serialize(bag->rvalue()) : void(*this->s << property->getName() << ' ');
    }
    void serialize(const PropertyBag& bag) override {
        for (auto* property : bag) serialize(property);
    }
    void flush() override { *this->s << '\n'; }
};

class MarshClasses : public Cpf {
protected:
    void SetUp() override {
        Cpf::SetUp();
        bag.ownProperty(new Property<int>("p", "", 2));
        storeProperty(bag, "s", new Property<double>("x", "", 0.5));
    }
};

}  // namespace

TEST_F(MarshClasses, OwnFormats) {
    std::ostringstream out;
    NamesMarshaller names(out);
    names.serialize(bag);
    names.flush();
    EXPECT_EQ("p x \n", out.str());
}

TEST_F(MarshClasses, StreamsGetWholeFiles) {
    std::ostringstream out;
    marsh::CPFMarshaller<std::ostream> marshaller(out);
    marshaller.serialize(bag);
    EXPECT_EQ("", out.str());
    marshaller.flush();
    putText(out.str());
    PropertyBag a, b, c;
    EXPECT_TRUE(marsh::CPFDemarshaller(file).deserialize(a));
    EXPECT_TRUE(marsh::TinyDemarshaller(file).deserialize(b));
    EXPECT_EQ(2, a.getPropertyType<int>("p")->get());
    EXPECT_EQ(0.5, Property<double>(findProperty(b, "s.x")).get());
    out.str("");
    marshaller.flush();
    putText(out.str());
    EXPECT_TRUE(marsh::CPFDemarshaller(file).deserialize(c));
    EXPECT_TRUE(c.empty()) << "everything was written before";
}

TEST_F(MarshClasses, LoaderTakesNamesAsLiterals) {
    TaskContext component("component");
    int a = 1, b = 2;
    component.addProperty("a", a);
    component.addProperty("b", b);
    const marsh::PropertyLoader loader(&component);
    ASSERT_TRUE(loader.save(file, "a"));
    a = b = 0;
    EXPECT_TRUE(loader.configure(file, "a"));
    EXPECT_EQ(1, a);
    EXPECT_FALSE(loader.configure(file, "b")) << "only 'a' was saved";
    EXPECT_FALSE(loader.configure(file)) << "strict";
    EXPECT_TRUE(loader.configure(file, false));
    EXPECT_TRUE(marsh::PropertyLoader(component.provides().get()).store(file));
    EXPECT_TRUE(loader.configure(file));
}
