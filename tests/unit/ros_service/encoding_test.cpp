// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values that have no bytes.
#include "service_fixture.hpp"

#include <rtt/SendHandle.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/types/SequenceTypeInfo.hpp>
#include <rtt/types/StructTypeInfo.hpp>
#include <rtt/types/Types.hpp>
#include <rtt_roscomm/detail/empty_struct.hpp>
#include <rtt_roscomm/message_table.hpp>

namespace deep {

struct Tree {
    std::vector<Tree> branches;
};
/** A value that nests too deeply to be encoded. */
Tree tooDeep() {
    Tree tree;
    for (int i = 0; i != 70; ++i) {
        Tree above;
        above.branches.push_back(std::move(tree));
        tree = std::move(above);
    }
    return tree;
}
/** Its default value cannot be encoded. */
struct Plant {
    Tree tree = tooDeep();
};
struct Hollow {
    std_srvs::EmptyRequest first;
    std_srvs::EmptyResponse second;
};
template <class A>
void serialize(A& a, Tree& t, unsigned) {
    a& boost::serialization::make_nvp("branches", t.branches);
}
template <class A>
void serialize(A& a, Plant& p, unsigned) {
    a& boost::serialization::make_nvp("tree", p.tree);
}
template <class A>
void serialize(A& a, Hollow& h, unsigned) {
    a& boost::serialization::make_nvp("first", h.first);
    a& boost::serialization::make_nvp("second", h.second);
}

}  // namespace deep

using namespace service_test;

namespace {

void loadPlants() {
    static const rtt_roscomm::ServiceEntry entry = {"deep_srvs/Plant", "11111111111111111111111111111111", "/Plant",
                                                    "/Plant"};
    const auto types = RTT::types::Types();
    types->addType(new RTT::types::StructTypeInfo<deep::Tree>("/Tree"));
    types->addType(new RTT::types::SequenceTypeInfo<std::vector<deep::Tree>>("/Tree[]"));
    types->addType(new RTT::types::StructTypeInfo<deep::Plant>("/Plant"));
    types->addType(new RTT::types::StructTypeInfo<deep::Hollow>("/Hollow"));
    rtt_roscomm::addServices(&entry, 1);
}

class ServiceEncodingTest : public ServiceTest {
protected:
    ServiceEncodingTest() {
        loadPlants();
        pump->requires_()->addOperationCaller(grow);
    }
    OperationCaller<bool(deep::Plant&, deep::Plant&)> grow{"grow"};
};

}  // namespace

TEST(ServiceCodecTest, OnlyStructsWithoutFieldsAreEmpty) {
    loadServices();
    loadPlants();
    using rtt_roscomm::detail::isEmptyStruct;
    const auto types = RTT::types::Types();
    EXPECT_TRUE(isEmptyStruct(*types->type("/std_srvs/EmptyRequest")));
    EXPECT_TRUE(isEmptyStruct(*types->type("/Hollow")));
    for (const char* other : {"/Plant", "/Tree", "/Tree[]", "/std_srvs/SetBoolRequest", "string", "double"})
        EXPECT_FALSE(isEmptyStruct(*types->type(other))) << other;
}

TEST_F(ServiceEncodingTest, ATypeWhoseDefaultValueCannotBeEncodedHasOthers) {
    const std::function<bool(deep::Plant&, deep::Plant&)> prune = [](deep::Plant& request, deep::Plant& response) {
        response.tree = std::move(request.tree);
        response.tree.branches.resize(1);
        return true;
    };
    pump->addOperation("prune", prune);
    ASSERT_TRUE(pump->services->connect("prune", "/grow", "deep_srvs/Plant"));
    ASSERT_TRUE(pump->services->connect("grow", "/grow", "deep_srvs/Plant"));
    deep::Plant request, response;
    request.tree = {};
    request.tree.branches.resize(3);
    ASSERT_TRUE(grow(request, response));
    ASSERT_EQ(1u, response.tree.branches.size());
    EXPECT_TRUE(response.tree.branches[0].branches.empty());
}

TEST_F(ServiceEncodingTest, ARequestThatCannotBeEncodedFails) {
    ASSERT_TRUE(pump->services->connect("grow", "/grow", "deep_srvs/Plant"));
    const LogText log;
    deep::Plant request, response;
    bool result = true;
    EXPECT_NO_THROW(result = grow(request, response));
    EXPECT_FALSE(result);
    EXPECT_TRUE(log.has("operation caller 'grow'")) << log.text();
    EXPECT_TRUE(log.has("a value of type /Plant cannot be encoded")) << log.text();
    RTT::SendHandle<bool(deep::Plant&, deep::Plant&)> handle;
    EXPECT_NO_THROW(handle = grow.send(request, response));
    EXPECT_EQ(RTT::SendFailure, handle.collect());
}
