// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Property.hpp>
#include <rtt/typekit/StdTypeInfo.hpp>
#include <rtt/types/TransportPlugin.hpp>
#include <rtt/types/TypeInfoName.hpp>
#include <rtt/types/TypeTransporter.hpp>
#include <rtt/types/TypekitPlugin.hpp>
#include <rtt/base/ChannelElementBase.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

using namespace RTT;
using namespace RTT::types;

namespace {

// One type per test: types are never removed.
template <int>
struct Tag {
    int value = 0;
};
template <int N>
std::ostream& operator<<(std::ostream& os, const Tag<N>& tag) {
    return os << "tag " << tag.value;
}

template <int N>
using TagInfo = TemplateTypeInfo<Tag<N>, true>;

TypeInfo* find(const std::string& name) { return Types()->type(name); }

}  // namespace

TEST(TypeRegistry, RegisteredTypeIsFoundByNameAndByCppType) {
    ASSERT_TRUE(Types()->addType(new TagInfo<1>("/registry/One")));
    TypeInfo* info = find("/registry/One");
    ASSERT_NE(nullptr, info);
    EXPECT_EQ("/registry/One", info->getTypeName());
    EXPECT_EQ(info, Types()->getTypeInfo<Tag<1>>());
    EXPECT_EQ(info, Types()->getTypeInfo<const Tag<1>&>());
    EXPECT_EQ(info, internal::DataSource<Tag<1>>::GetTypeInfo());
    EXPECT_STREQ(typeid(Tag<1>).name(), info->getTypeIdName());
}

TEST(TypeRegistry, NamesAreFoundWithDots) {
    ASSERT_TRUE(Types()->addType(new TagInfo<2>("/registry/box</registry/One>")));
    EXPECT_EQ(Types()->getTypeInfo<Tag<2>>(), find("registry.box<registry.One>"));
    EXPECT_EQ("registry.box<registry.One>", Types()->toDot("/registry/box</registry/One>"));
    EXPECT_EQ("int", Types()->toDot("int"));
}

TEST(TypeRegistry, SecondNameBecomesAnAlias) {
    ASSERT_TRUE(Types()->addType(new TagInfo<3>("registry_first")));
    ASSERT_TRUE(Types()->addType(new TagInfo<3>("registry_second")));
    TypeInfo* info = find("registry_second");
    EXPECT_EQ(find("registry_first"), info);
    EXPECT_EQ("registry_first", info->getTypeName());
    EXPECT_TRUE(info->isType("registry_second"));
    EXPECT_EQ(2u, info->getTypeNames().size());
}

TEST(TypeRegistry, AliasesAreAddedByHand) {
    ASSERT_TRUE(Types()->addType(new TagInfo<20>("registry_named")));
    ASSERT_TRUE(Types()->addType(new TagInfo<21>("registry_other")));
    TypeInfo* info = find("registry_named");
    EXPECT_TRUE(Types()->aliasType("registry_nickname", info));
    EXPECT_EQ(info, find("registry_nickname"));
    EXPECT_FALSE(Types()->aliasType("registry_other", info));
    EXPECT_FALSE(Types()->aliasType("registry_nobody", nullptr));
    TypeInfoRepository::Release();
    EXPECT_EQ(info, find("registry_nickname"));
}

TEST(TypeRegistry, AliasesOfATypeAreFound) {
    ASSERT_TRUE(Types()->addType(new TagInfo<22>("registry_formal")));
    TypeInfo* info = find("registry_formal");
    EXPECT_TRUE(info->addAlias("/registry/Informal"));
    EXPECT_EQ(info, find("/registry/Informal"));
    EXPECT_EQ(info, find("registry.Informal"));
    EXPECT_TRUE(info->isType("/registry/Informal"));
    EXPECT_FALSE(info->addAlias("/registry/Informal")) << "has it already";
    EXPECT_FALSE(info->addAlias("registry_formal"));
    EXPECT_EQ(2u, info->getTypeNames().size());
    ASSERT_TRUE(Types()->addType(new TagInfo<23>("registry_stranger")));
    EXPECT_FALSE(info->addAlias("registry_stranger")) << "belongs to another type";
    EXPECT_FALSE(info->isType("registry_stranger"));
    EXPECT_NE(info, find("registry_stranger"));
}

TEST(TypeRegistry, AliasesGivenBeforeTheTypeIsRegisteredAreFoundAfterwards) {
    auto* info = new TypeInfo("registry_unregistered", &typeid(Tag<24>));
    EXPECT_TRUE(info->addAlias("registry_early"));
    EXPECT_EQ(nullptr, find("registry_early"));
    ASSERT_TRUE(Types()->addType(info));
    EXPECT_EQ(info, find("registry_early"));

    struct Aliased : TagInfo<25> {
        Aliased() : TagInfo<25>("registry_by_generator") {}
        bool installTypeInfoObject(TypeInfo* type) override {
            TagInfo<25>::installTypeInfoObject(type);
            return type->addAlias("registry_by_generator_too") && false;
        }
    };
    ASSERT_TRUE(Types()->addType(new Aliased()));
    EXPECT_EQ(find("registry_by_generator"), find("registry_by_generator_too"));
}

TEST(TypeRegistry, SameNameForTheSameTypeIsNoError) {
    ASSERT_TRUE(Types()->addType(new TagInfo<4>("registry_again")));
    EXPECT_TRUE(Types()->addType(new TagInfo<4>("registry_again")));
    EXPECT_EQ(1u, find("registry_again")->getTypeNames().size());
}

TEST(TypeRegistry, NameOfAnotherTypeIsRefused) {
    ASSERT_TRUE(Types()->addType(new TagInfo<5>("registry_taken")));
    EXPECT_FALSE(Types()->addType(new TagInfo<6>("registry_taken")));
    EXPECT_EQ(nullptr, Types()->getTypeInfo<Tag<6>>());
    EXPECT_EQ(find("registry_taken"), Types()->getTypeInfo<Tag<5>>());
}

TEST(TypeRegistry, UnknownNamesAskTheAutoLoaderOnce) {
    int asked = 0;
    Types()->setAutoLoader([&asked](const std::string& name) {
        ++asked;
        return name == "registry_loaded" && Types()->addType(new TagInfo<7>("registry_loaded"));
    });
    EXPECT_EQ(nullptr, find("registry_nowhere"));
    EXPECT_NE(nullptr, find("registry_loaded"));
    EXPECT_EQ(2, asked);
    find("registry_loaded");
    EXPECT_EQ(2, asked);
    Types()->setAutoLoader(boost::function<bool(const std::string&)>());
}

TEST(TypeRegistry, PropertiesMadeBeforeTheTypekitSeeItsTypes) {
    Property<Tag<8>> property("p", "");
    EXPECT_EQ("unknown_t", property.getType());
    ASSERT_TRUE(Types()->addType(new TagInfo<8>("registry_late")));
    EXPECT_EQ("registry_late", property.getType());
}

TEST(TypeRegistry, TypeMakesValuesVariablesAndProperties) {
    ASSERT_TRUE(Types()->addType(new TagInfo<9>("registry_maker")));
    TypeInfo* info = find("registry_maker");
    base::DataSourceBase::shared_ptr value = info->buildValue();
    ASSERT_NE(nullptr, internal::AssignableDataSource<Tag<9>>::narrow(value.get()));
    internal::AssignableDataSource<Tag<9>>::narrow(value.get())->set().value = 4;
    EXPECT_EQ("tag 4", info->toString(value));

    const std::unique_ptr<base::PropertyBase> shared(info->buildProperty("p", "doc", value));
    internal::AssignableDataSource<Tag<9>>::narrow(value.get())->set().value = 5;
    EXPECT_EQ("tag 5", info->toString(shared->getDataSource())) << "a property on a source shares its value";

    const std::unique_ptr<base::AttributeBase> variable(info->buildVariable("v"));
    EXPECT_TRUE(variable->getDataSource()->isAssignable());
    const std::unique_ptr<base::AttributeBase> constant(info->buildConstant("c", value));
    EXPECT_FALSE(constant->getDataSource()->isAssignable());
    const std::unique_ptr<base::AttributeBase> alias(info->buildAlias("a", value));
    EXPECT_EQ(value, alias->getDataSource());
    Tag<9> outside;
    EXPECT_EQ(&outside, info->buildReference(&outside)->getRawPointer());
    base::DataSourceBase::shared_ptr other(new internal::ValueDataSource<Tag<1>>());
    EXPECT_EQ(nullptr, info->buildAlias("a", other));
    EXPECT_EQ(nullptr, info->buildProperty("p", "", other));
}

TEST(TypeRegistry, UnknownTypeMakesNothing) {
    const TypeInfo* unknown = internal::DataSource<Tag<10>>::GetTypeInfo();
    EXPECT_EQ(nullptr, unknown->buildValue());
    EXPECT_EQ(nullptr, unknown->buildProperty("p", ""));
    EXPECT_EQ(nullptr, unknown->inputPort("in"));
    EXPECT_TRUE(unknown->getMemberNames().empty());
}

TEST(TypeRegistry, NamedOnlyTypeCannotBeMade) {
    ASSERT_TRUE(Types()->addType(new TypeInfoName<Tag<11>>("registry_name_only")));
    EXPECT_EQ("registry_name_only", internal::DataSource<Tag<11>>::GetType());
    EXPECT_EQ(nullptr, find("registry_name_only")->buildValue());
}

TEST(TypeRegistry, ListsAreSorted) {
    const auto names = Types()->getTypes();
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
    const auto dotted = Types()->getDottedTypes();
    EXPECT_EQ(0, std::count_if(dotted.begin(), dotted.end(), [](const std::string& n) { return n[0] == '/'; }));
}

namespace {

struct CountingTransport : TransportPlugin {
    static int& offers(const std::string& name) {
        static std::map<std::string, int> counts;
        return counts[name];
    }
    struct Transporter : TypeTransporter {
        base::ChannelElementBase::shared_ptr createStream(base::PortInterface*, const ConnPolicy&,
                                                          bool) const override {
            return nullptr;
        }
    };
    bool registerTransport(std::string name, TypeInfo* info) override {
        ++offers(name);
        return info->addProtocol(77, new Transporter());
    }
    std::string getTransportName() const override { return "counting"; }
    std::string getTypekitName() const override { return "none"; }
    std::string getName() const override { return "counting-transport"; }
};

struct EmptyTypekit : TypekitPlugin {
    explicit EmptyTypekit(std::string& calls) : calls_(calls) {}
    bool loadTypes() override { return note("types "); }
    bool loadConstructors() override { return note("constructors "); }
    bool loadOperators() override { return note("operators "); }
    bool loadGlobals() override { return note("globals "); }
    std::string getName() override { return "registry-empty-typekit"; }
    bool note(const char* what) {
        calls_ += what;
        return true;
    }
    std::string& calls_;
};

}  // namespace

TEST(TypeRegistry, TransportsAreOfferedEarlierAndLaterTypes) {
    ASSERT_TRUE(Types()->addType(new TagInfo<12>("registry_before")));
    ASSERT_TRUE(TypekitRepository::Import(new CountingTransport()));
    ASSERT_TRUE(Types()->addType(new TagInfo<13>("registry_after")));
    EXPECT_EQ(1, CountingTransport::offers("registry_before"));
    EXPECT_EQ(1, CountingTransport::offers("registry_after"));
    EXPECT_EQ(1, CountingTransport::offers("unknown_t"));
    EXPECT_TRUE(find("registry_after")->hasProtocol(77));
    EXPECT_FALSE(find("registry_after")->addProtocol(77, new CountingTransport::Transporter()));
    EXPECT_EQ(nullptr, find("registry_after")->getProtocol(78));
    EXPECT_TRUE(TypekitRepository::Import(new CountingTransport())) << "a second one of the same name is dropped";
    EXPECT_EQ(1, CountingTransport::offers("unknown_t"));
}

TEST(TypeRegistry, TypekitIsLoadedOnceInOrder) {
    std::string calls;
    EXPECT_TRUE(TypekitRepository::Import(new EmptyTypekit(calls)));
    EXPECT_EQ("types constructors operators globals ", calls);
    EXPECT_TRUE(TypekitRepository::Import(new EmptyTypekit(calls)));
    EXPECT_EQ("types constructors operators globals ", calls);
    EXPECT_TRUE(TypekitRepository::hasTypekit("registry-empty-typekit"));
}

TEST(TypeRegistry, ManyThreadsRegisterAndLookUp) {
    auto run = [](int first) {
        for (int i = 0; i != 50; ++i) {
            Types()->addType(new TypeInfo("registry_thread_" + std::to_string(first + i)));
            Types()->type("registry_thread_" + std::to_string(i));
            internal::DataSource<Tag<14>>::GetTypeInfo();
        }
    };
    std::thread a(run, 0), b(run, 100);
    a.join();
    b.join();
    EXPECT_NE(nullptr, find("registry_thread_149"));
}
