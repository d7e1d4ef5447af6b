// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values of every struct of the golden typekits: every field is given a value, which then goes through a property file,
// a port, a property and scripts, and must come out unchanged.
#include <filesystem>
#include <memory>

#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/marsh/PropertyDemarshaller.hpp>
#include <rtt/marsh/PropertyMarshaller.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <support/temp_dir.hpp>

#include "golden_typekit.hpp"
#include "value_filler.hpp"

namespace fs = std::filesystem;
using namespace oroforge;
using RTT::base::DataSourceBase;
using RTT::types::TypeInfo;
using SourcePtr = DataSourceBase::shared_ptr;

namespace {

class TypekitValues : public test::GoldenTypekit {
protected:
    /// Each struct, with a value of all fields filled.
    template <class Action>
    void forEachStruct(Action&& action) {
        for (const model::Struct& type : model.structs) {
            SCOPED_TRACE(type.name);
            const TypeInfo& info = typeOf(type.name);
            const SourcePtr value = info.buildValue();
            ASSERT_TRUE(value);
            if (!type.assignable) continue;  // nothing to give to it
            test::ValueFiller filler(model);
            filler.fill(value);
            const SourcePtr fresh = info.buildValue();
            if (!type.fields.empty() && type.size > 1) {
                EXPECT_NE(value->toString(), fresh->toString());
            }
            action(info, value, filler);
        }
    }

    void surviveAPropertyFile();
    void surviveAPort();
    void surviveAProperty();
    void areReadAndWrittenByScriptsMemberByMember();
};

void TypekitValues::surviveAPropertyFile() {
    const test::TempDir dir;
    forEachStruct([&](const TypeInfo& info, const SourcePtr& value, test::ValueFiller&) {
        const std::string file = (dir.path() / "value.cpf").string();
        RTT::PropertyBag bag;
        bag.ownProperty(info.buildProperty("p", "", value));
        {
            RTT::marsh::PropertyMarshaller marshaller(file);
            marshaller.serialize(bag);
        }
        RTT::PropertyBag read;
        RTT::marsh::PropertyDemarshaller demarshaller(file);
        ASSERT_TRUE(demarshaller.deserialize(read));
        ASSERT_EQ(read.size(), 1u);
        const SourcePtr again = info.buildValue();
        EXPECT_TRUE(info.composeType(read.getItem(0)->getDataSource(), again));
        EXPECT_EQ(again->toString(), value->toString());
    });
}

void TypekitValues::surviveAPort() {
    forEachStruct([&](const TypeInfo& info, const SourcePtr& value, test::ValueFiller&) {
        const std::unique_ptr<RTT::base::OutputPortInterface> out(info.outputPort("out"));
        const std::unique_ptr<RTT::base::InputPortInterface> in(info.inputPort("in"));
        if (!out && !in) return;  // no sample
        ASSERT_TRUE(out->connectTo(in.get()));
        out->write(value);
        const SourcePtr again = info.buildValue();
        EXPECT_EQ(in->read(again), RTT::NewData);
        EXPECT_EQ(again->toString(), value->toString());
    });
}

void TypekitValues::surviveAProperty() {
    forEachStruct([&](const TypeInfo& info, const SourcePtr& value, test::ValueFiller&) {
        const std::unique_ptr<RTT::base::PropertyBase> from(info.buildProperty("p", "", value));
        const std::unique_ptr<RTT::base::PropertyBase> to(info.buildProperty("p", ""));
        EXPECT_TRUE(to->update(from.get()));
        EXPECT_EQ(to->getDataSource()->toString(), value->toString());
    });
}

void TypekitValues::areReadAndWrittenByScriptsMemberByMember() {
    forEachStruct([&](const TypeInfo& info, const SourcePtr& value, test::ValueFiller& filler) {
        RTT::TaskContext component("component");
        RTT::scripting::ScriptingService scripts(&component);
        const SourcePtr copy = info.buildValue();
        ASSERT_TRUE(copy->update(value.get()));
        test::ValueFiller other(model, 1);
        other.fill(copy);
        const std::unique_ptr<RTT::base::AttributeBase> from(info.buildAttribute("from", value));
        const std::unique_ptr<RTT::base::AttributeBase> to(info.buildAttribute("to", copy));
        component.addAttribute(*from);
        component.addAttribute(*to);
        for (const std::string& path : filler.paths())
            EXPECT_TRUE(scripts.eval("to" + path + " = from" + path)) << path;
        EXPECT_EQ(copy->toString(), value->toString());
        component.provides()->clear();
    });
}

}  // namespace

TEST_P(TypekitValues, SurviveFilesPortsPropertiesAndScripts) {
    surviveAPropertyFile();
    surviveAPort();
    surviveAProperty();
    areReadAndWrittenByScriptsMemberByMember();
}

INSTANTIATE_TEST_SUITE_P(Golden, TypekitValues, testing::ValuesIn(test::builtTypekits()), test::caseName);
