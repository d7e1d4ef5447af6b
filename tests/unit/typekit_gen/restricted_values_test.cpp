// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Types that cannot be assigned, or not be made without arguments: properties, attributes and script values, no samples.
#include <memory>

#include <input.hpp>  // of the golden case "restricted"
#include <rtt/Attribute.hpp>
#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/Types.hpp>
#include <types/restricted/typekit/Types.hpp>

#include <dlfcn.h>

#include <gtest/gtest.h>

using RTT::base::DataSourceBase;
using SourcePtr = DataSourceBase::shared_ptr;

extern "C" bool loadRTTPlugin(RTT::TaskContext*);  // of the typekit, which is linked in

namespace {

using LoadPlugin = bool (*)(RTT::TaskContext*);

class RestrictedValues : public testing::Test {
protected:
    static void SetUpTestSuite() {
        void* const library = ::dlopen(RTT_TYPEKIT_FILE, RTLD_NOW | RTLD_LOCAL);
        ASSERT_NE(library, nullptr) << ::dlerror();
        ASSERT_TRUE(reinterpret_cast<LoadPlugin>(::dlsym(library, "loadRTTPlugin"))(nullptr));
        ASSERT_TRUE(loadRTTPlugin(nullptr));
    }
};

const char* const kFixedText = "{version = 3, scale = {0.5, 2}, value = 1}";

}  // namespace

static_assert(!RTT::types::isSample<restricted::Fixed> && !RTT::types::isSample<restricted::Holder>);
static_assert(!RTT::types::isSample<restricted::Sized> && !RTT::types::isSample<restricted::Level>);
static_assert(RTT::types::isSample<restricted::Outer>);

TEST_F(RestrictedValues, ConstantOnesAreReadOnlyProperties) {
    const RTT::Property<restricted::Fixed> property("p", "");
    const SourcePtr source = property.getDataSource();
    EXPECT_FALSE(source->isAssignable());
    EXPECT_EQ(source->toString(), kFixedText);
    const restricted::Fixed other{4, {1, 1}, 5};
    EXPECT_FALSE(source->assignValue(&other));
    EXPECT_EQ(property.rvalue().value, 1);
    const std::unique_ptr<RTT::base::PropertyBase> copy(property.clone());
    EXPECT_EQ(copy->getDataSource()->toString(), kFixedText);
    EXPECT_FALSE(copy->update(&property));
}

TEST_F(RestrictedValues, ConstantOnesCanBeWrittenToFiles) {
    const RTT::Property<restricted::Fixed> property("p", "");
    const SourcePtr parts = property.getTypeInfo()->decomposeType(property.getDataSource());
    const auto* bag = RTT::internal::DataSource<RTT::PropertyBag>::narrow(parts.get());
    ASSERT_NE(bag, nullptr);
    ASSERT_EQ(bag->rvalue().size(), 3u);
    EXPECT_EQ(bag->rvalue().getItem(0)->getDataSource()->toString(), "3");
    EXPECT_EQ(bag->rvalue().getItem(0)->getDescription(), "of the format");
}

TEST_F(RestrictedValues, ScriptsReadConstantOnes) {
    RTT::TaskContext component("component");
    RTT::scripting::ScriptingService scripts(&component);
    restricted::Holder holder;
    double number = 0;
    component.addProperty("holder", holder);
    component.addProperty("number", number);
    EXPECT_TRUE(scripts.eval("number = holder.fixed.version + holder.fixed.scale[1] + holder.number"));
    EXPECT_EQ(number, 6);
    EXPECT_FALSE(scripts.eval("holder.fixed.version = 2"));
    EXPECT_FALSE(scripts.eval("holder = holder"));
    component.provides()->clear();
}

TEST_F(RestrictedValues, FirstValuesAreMadeAsToldByTheType) {
    const RTT::Property<restricted::Sized> sized("p", "");
    EXPECT_EQ(sized.rvalue().size, restricted::kSmallest);
    const std::unique_ptr<RTT::base::PropertyBase> created(sized.create());
    EXPECT_EQ(created->getDataSource()->toString(), "{size = 8}");
    const RTT::Attribute<restricted::Level> level("a");
    EXPECT_EQ(level.get().value, 0);
    EXPECT_EQ(RTT::types::Types()->type("/restricted/Sized")->buildValue()->toString(), "{size = 8}");
}
