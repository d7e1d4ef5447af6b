// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Properties, bags, attributes and their files, as components use them.
#include <rtt/Attribute.hpp>
#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/marsh/Marshalling.hpp>
#include <rtt/marsh/PropertyDemarshaller.hpp>
#include <rtt/marsh/PropertyLoader.hpp>
#include <rtt/marsh/PropertyMarshaller.hpp>
#include <rtt/types/PropertyComposition.hpp>
#include <rtt/types/PropertyDecomposition.hpp>

#include <gtest/gtest.h>

using namespace RTT;

namespace {

class Tool : public TaskContext {
public:
    Property<double> mass;
    Property<std::vector<double>> offset;
    Property<PropertyBag> geometry;
    std::string frame;
    int count;

    Tool()
        : TaskContext("tool", PreOperational),
          mass("mass", "in kg", 1.5),
          offset("offset", "of the tip", std::vector<double>(3, 0.0)),
          geometry("geometry", "of the tool", PropertyBag()),
          count(0) {
        addProperty(mass);
        properties()->addProperty(offset);
        addProperty(geometry);
        addProperty("frame", frame).doc("in which it is");
        geometry.value().ownProperty(new Property<double>("length", "", 0.2));
        geometry.set().addProperty("count", count);
    }
};

/** A file in the folder of the test, gone afterwards. */
struct File {
    std::string name;
    File(const std::string& n) : name(n) {}
    ~File() { remove(name.c_str()); }
};

}  // namespace

TEST(UserCode, UsesProperties) {
    Tool tool;
    EXPECT_EQ(tool.mass.get(), 1.5);
    tool.mass.set(2.5);
    tool.mass = 3.5;
    EXPECT_EQ(tool.mass.rvalue(), 3.5);
    double copy = tool.mass;
    EXPECT_EQ(copy, 3.5);
    tool.offset.set()[2] = 0.1;
    tool.offset.value()[1] = 0.2;
    EXPECT_EQ(tool.offset.rvalue()[2] + tool.offset.value()[1], 0.1 + 0.2);
    base::PropertyBase* base = tool.getProperty("mass");
    ASSERT_TRUE(base != 0);
    EXPECT_EQ(base->getType(), "double");
    EXPECT_EQ(base->getDescription(), "in kg");
    base->setDescription("kg");
    base->setName("weight");
    EXPECT_EQ(tool.mass.getName(), "weight");
    Property<double>* typed = dynamic_cast<Property<double>*>(base);
    ASSERT_TRUE(typed);
    EXPECT_EQ(Property<double>::narrow(base), typed);
    boost::shared_ptr<base::PropertyBase> clone(base->clone());
    EXPECT_TRUE(clone->ready());
    typed->set(9.0);
    EXPECT_TRUE(clone->refresh(base));
    EXPECT_EQ(clone->getDataSource()->toString(), "9");
    EXPECT_EQ(internal::DataSource<double>::narrow(clone->getDataSource().get())->get(), 9.0);
    EXPECT_EQ(internal::AssignableDataSource<double>::narrow(base->getDataSource().get())->set(), 9.0);
}

TEST(UserCode, WalksThroughBags) {
    Tool tool;
    PropertyBag* bag = tool.properties();
    std::string names;
    for (PropertyBag::iterator it = bag->begin(); it != bag->end(); ++it) {
        if (Property<PropertyBag>* inner = Property<PropertyBag>::narrow(*it)) {
            for (PropertyBag::const_iterator in = inner->rvalue().begin(); in != inner->rvalue().end(); ++in)
                names += (*in)->getName() + ".";
        } else
            names += (*it)->getName() + ";";
    }
    EXPECT_EQ(names, "mass;offset;length.count.frame;");
    EXPECT_TRUE(bag->find("nothing") == NULL);
    EXPECT_EQ(bag->getItem(0), &tool.mass);
    EXPECT_EQ(bag->getProperties().size(), 4u);
    EXPECT_EQ(bag->list().front(), "mass");
    EXPECT_EQ(listProperties(*bag).size(), 6u);
    EXPECT_EQ(findProperty(*bag, "geometry.length")->getName(), "length");
    PropertyBag other("Other");
    other.setType("Another");
    EXPECT_EQ(other.getType(), "Another");
    EXPECT_TRUE(copyProperties(other, *bag));
    EXPECT_TRUE(other.ownsProperty(other.find("mass")));
    other.getPropertyType<double>("mass")->set(7.0);
    EXPECT_TRUE(refreshProperties(*bag, other));
    EXPECT_EQ(tool.mass.get(), 7.0);
    EXPECT_TRUE(updateProperties(other, *bag));
    EXPECT_TRUE(other.findValue<double>(7.0));
    EXPECT_TRUE(other.removeProperty(other.find("mass")));
    other.clear();
    EXPECT_TRUE(other.empty());
    tool.provides()->removeProperty(tool.mass);
    EXPECT_TRUE(tool.properties()->getProperty("mass") == 0);
}

TEST(UserCode, TakesValuesApart) {
    std::vector<double> values(2, 1.5);
    Property<std::vector<double>> property("values", "", values);
    PropertyBag parts;
    ASSERT_TRUE(types::propertyDecomposition(&property, parts));
    EXPECT_EQ(parts.size(), 2u);
    Property<PropertyBag> bag("values", "", parts);
    PropertyBag target;
    ASSERT_TRUE(types::decomposePropertyBag(*Tool().properties(), target));
    Property<std::vector<double>> again("again", "");
    EXPECT_TRUE(again.getTypeInfo()->composeType(bag.getDataSource(), again.getDataSource()));
    EXPECT_EQ(again.rvalue(), values);
}

TEST(UserCode, WritesAndReadsItsProperties) {
    File file("api_property_usage.cpf");
    Tool tool;
    ASSERT_TRUE(tool.loadService("marshalling"));
    boost::shared_ptr<Marshalling> m = tool.getProvider<Marshalling>("marshalling");
    ASSERT_TRUE(m && m->ready());
    tool.frame = "flange";
    EXPECT_TRUE(m->writeProperties(file.name));
    tool.frame = "";
    tool.mass.set(0.0);
    tool.offset.set().clear();
    EXPECT_TRUE(m->readProperties(file.name));
    EXPECT_EQ(tool.frame, "flange");
    EXPECT_EQ(tool.mass.get(), 1.5);
    EXPECT_EQ(tool.offset.rvalue().size(), 3u);
    EXPECT_TRUE(m->updateProperties(file.name) && m->loadProperties(file.name) && m->storeProperties(file.name));
    EXPECT_TRUE(m->writeProperty("mass", file.name) && m->readProperty("mass", file.name) && m->updateFile(file.name));
    EXPECT_FALSE(m->loadProperties("no such file.cpf"));
    OperationCaller<bool(const std::string&)> load = tool.provides("marshalling")->getOperation("loadProperties");
    EXPECT_TRUE(load(file.name));
}

TEST(UserCode, LoadsAServiceByAskingForIt) {
    TaskContext task("task");
    boost::shared_ptr<Marshalling> asked = task.getProvider<Marshalling>("marshalling");
    ASSERT_TRUE(asked);
    EXPECT_TRUE(asked->ready());
    EXPECT_TRUE(task.provides()->hasService("marshalling"));
}

TEST(UserCode, WritesFilesItself) {
    File file("api_property_marshaller.cpf");
    Tool tool;
    {
        marsh::PropertyMarshaller marshaller(file.name);
        marshaller.serialize(*tool.properties());
        marshaller.flush();
    }
    PropertyBag read;
    marsh::PropertyDemarshaller demarshaller(file.name);
    ASSERT_TRUE(demarshaller.deserialize(read));
    EXPECT_EQ(read.getPropertyType<double>("mass")->get(), 1.5);
    PropertyBag composed;
    EXPECT_TRUE(types::composePropertyBag(read, composed));
    Property<std::vector<double>> offset = composed.getProperty("offset");
    ASSERT_TRUE(offset.ready());
    EXPECT_EQ(offset.rvalue().size(), 3u);
    marsh::PropertyLoader loader(&tool);
    EXPECT_TRUE(loader.configure(file.name, true));
    EXPECT_TRUE(loader.save(file.name, true));
}

TEST(UserCode, UsesAttributes) {
    Attribute<double> speed("speed", 1.0);
    Attribute<double> alias(&speed);
    alias.set(2.0);
    EXPECT_EQ(speed.get(), 2.0);
    Constant<std::string> name("name", "value");
    base::AttributeBase& any = name;
    EXPECT_EQ(any.getDataSource()->toString(), "value");
    Alias second("second", speed.getDataSource());
    EXPECT_EQ(second.getDataSource(), speed.getDataSource());
    TaskContext task("task");
    EXPECT_TRUE(task.attributes()->setValue(new Attribute<int>("made", 5)));
    EXPECT_EQ(Attribute<int>(task.attributes()->getAttribute("made")).get(), 5);
    EXPECT_TRUE(task.attributes()->removeAttribute("made"));
    EXPECT_FALSE(task.attributes()->hasAttribute("made"));
    EXPECT_FALSE(task.attributes()->getAttributeNames().empty());
}
