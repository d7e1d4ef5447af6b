// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Members of elements of containers: they follow the index, and the container when it is resized.
#include "builtin_typekit.hpp"
#include "sample_types.hpp"

#include <map>
#include <vector>

using namespace RTT;
using namespace types_test;
using sample::Point;
using sample::Tank;

namespace {

typedef std::vector<Point> Path;
typedef std::vector<Tank> Tanks;

class ElementMembers : public WithBuiltinTypes {
protected:
    static void SetUpTestSuite() {
        WithBuiltinTypes::SetUpTestSuite();
        sample::addTypes();
        types::Types()->addType(types::makeSequenceType<Tanks>("/std/vector</sample/Tank>"));
    }
    static Path pathOf(int length) {
        Path path;
        for (int i = 0; i < length; ++i) path.push_back({10.0 * i, 10.0 * i + 1});
        return path;
    }
    /** Those that become others in a copy. */
    template <class T>
    static boost::intrusive_ptr<internal::ValueDataSource<T>> local(const T& value) {
        return new internal::UnboundDataSource<internal::ValueDataSource<T>>(value);
    }
    static SourcePtr element(const SourcePtr& of, const boost::intrusive_ptr<internal::ValueDataSource<int>>& index) {
        return of->getMember(SourcePtr(index));
    }
    /** What has another address afterwards. */
    template <class Container>
    static void grow(Container& container) {
        container.resize(container.capacity() + 1000);
    }

    boost::intrusive_ptr<internal::ValueDataSource<int>> index = variable(0), inner = variable(0);
};

}  // namespace

TEST_F(ElementMembers, FollowTheIndex) {
    const auto path = variable(pathOf(3));
    const SourcePtr x = element(path, index)->getMember("x"), y = element(path, index)->getMember("y");
    for (int i : {0, 1, 2, 1, 0}) {
        index->set(i);
        EXPECT_EQ(10.0 * i, valueOf<double>(x));
        EXPECT_EQ(10.0 * i + 1, valueOf<double>(y));
    }
    for (int i = 0; i != 3; ++i) {
        index->set(i);
        EXPECT_TRUE(x->update(variable(0.5 * i).get()));
    }
    EXPECT_EQ(0.0, path->rvalue()[0].x);
    EXPECT_EQ(0.5, path->rvalue()[1].x);
    EXPECT_EQ(1.0, path->rvalue()[2].x);
    EXPECT_EQ(21.0, path->rvalue()[2].y);
}

TEST_F(ElementMembers, FollowTheContainerWhenItIsResized) {
    const auto path = variable(pathOf(2));
    index->set(1);
    const SourcePtr x = element(path, index)->getMember("x");
    EXPECT_EQ(10.0, valueOf<double>(x));
    grow(path->set());
    EXPECT_EQ(10.0, valueOf<double>(x));
    path->set()[1].x = 7;
    EXPECT_EQ(7.0, valueOf<double>(x));
    EXPECT_TRUE(x->update(variable(8.0).get()));
    EXPECT_EQ(8.0, path->rvalue()[1].x);
    path->set(pathOf(5));
    EXPECT_EQ(10.0, valueOf<double>(x));
}

TEST_F(ElementMembers, OfElementsThatAreNotThereHaveADefaultValue) {
    const auto path = variable(pathOf(3));
    index->set(2);
    const SourcePtr x = element(path, index)->getMember("x");
    path->set().resize(1);
    path->set().shrink_to_fit();
    EXPECT_EQ(0.0, valueOf<double>(x));
    EXPECT_TRUE(x->update(variable(5.0).get()));
    EXPECT_EQ(0.0, path->rvalue()[0].x);
    index->set(-1);
    EXPECT_EQ(0.0, valueOf<double>(x));
    path->set().clear();
    index->set(0);
    EXPECT_EQ(0.0, valueOf<double>(x));
}

TEST_F(ElementMembers, MayBeMadeBeforeTheElements) {
    const auto path = variable(Path());
    const SourcePtr x = element(path, index)->getMember("x");
    ASSERT_TRUE(x);
    EXPECT_EQ(0.0, valueOf<double>(x));
    path->set(pathOf(2));
    index->set(1);
    EXPECT_EQ(10.0, valueOf<double>(x));
}

TEST_F(ElementMembers, OfConstantsAreReadOnly) {
    const SourcePtr path(new internal::ConstantDataSource<Path>(pathOf(2)));
    index->set(1);
    const SourcePtr x = element(path, index)->getMember("x");
    ASSERT_TRUE(x);
    EXPECT_EQ(10.0, valueOf<double>(x));
    index->set(0);
    EXPECT_EQ(0.0, valueOf<double>(x));
    EXPECT_FALSE(x->update(variable(1.0).get()));
}

TEST_F(ElementMembers, ArraysWithinThemFollowToo) {
    const auto tanks = variable(Tanks(2));
    for (int i : {0, 1})
        for (int k : {0, 1, 2}) tanks->set()[static_cast<std::size_t>(i)].weights[k] = 10 * i + k;
    const SourcePtr weights = element(tanks, index)->getMember("weights");
    const SourcePtr weight = element(weights, inner), second = weights->getMember("1");
    for (int i : {1, 0, 1}) {
        index->set(i);
        for (int k : {2, 0, 1}) {
            inner->set(k);
            EXPECT_EQ(10.0 * i + k, valueOf<double>(weight));
        }
        EXPECT_EQ(10.0 * i + 1, valueOf<double>(second));
    }
    grow(tanks->set());
    inner->set(2);
    EXPECT_EQ(12.0, valueOf<double>(weight));
    EXPECT_TRUE(weight->update(variable(5.5).get()));
    EXPECT_TRUE(second->update(variable(6.5).get()));
    EXPECT_EQ(5.5, tanks->rvalue()[1].weights[2]);
    EXPECT_EQ(6.5, tanks->rvalue()[1].weights[1]);
    EXPECT_EQ(0.0, tanks->rvalue()[0].weights[0]);
}

TEST_F(ElementMembers, OfElementsOfElements) {
    const auto tanks = variable(Tanks(2));
    tanks->set()[0].path = pathOf(1);
    tanks->set()[1].path = pathOf(3);
    const SourcePtr x = element(element(tanks, index)->getMember("path"), inner)->getMember("x");
    EXPECT_EQ(0.0, valueOf<double>(x));
    index->set(1);
    inner->set(2);
    EXPECT_EQ(20.0, valueOf<double>(x));
    grow(tanks->set());
    EXPECT_EQ(20.0, valueOf<double>(x));
    grow(tanks->set()[1].path);
    EXPECT_EQ(20.0, valueOf<double>(x));
    EXPECT_TRUE(x->update(variable(3.0).get()));
    EXPECT_EQ(3.0, tanks->rvalue()[1].path[2].x);
    index->set(0);
    EXPECT_EQ(0.0, valueOf<double>(x)) << "that tank has one point only";
}

TEST_F(ElementMembers, OfMembersOfElements) {
    const auto tanks = variable(Tanks(2));
    tanks->set()[1].position.y = 4;
    const SourcePtr y = element(tanks, index)->getMember("position")->getMember("y");
    EXPECT_EQ(0.0, valueOf<double>(y));
    index->set(1);
    EXPECT_EQ(4.0, valueOf<double>(y));
    grow(tanks->set());
    EXPECT_TRUE(y->update(variable(2.0).get()));
    EXPECT_EQ(2.0, tanks->rvalue()[1].position.y);
}

TEST_F(ElementMembers, ClonesReferToTheSameContainer) {
    const auto path = variable(pathOf(3));
    const SourcePtr x = element(path, index)->getMember("x");
    const SourcePtr clone(x->clone());
    index->set(2);
    EXPECT_EQ(20.0, valueOf<double>(clone));
    grow(path->set());
    EXPECT_TRUE(clone->update(variable(1.0).get()));
    EXPECT_EQ(1.0, valueOf<double>(x));
}

TEST_F(ElementMembers, CopiesReferToTheCopies) {
    const auto path = local(pathOf(3));
    const auto index = local(1);
    const SourcePtr x = path->getMember(SourcePtr(index))->getMember("x");
    std::map<const base::DataSourceBase*, base::DataSourceBase*> copies;
    const SourcePtr copy(x->copy(copies));
    ASSERT_TRUE(copies.count(path.get()) && copies.count(index.get()));
    const auto pathCopy = internal::ValueDataSource<Path>::narrow(copies[path.get()]);
    const auto indexCopy = internal::ValueDataSource<int>::narrow(copies[index.get()]);
    ASSERT_TRUE(pathCopy && indexCopy && pathCopy != path.get() && indexCopy != index.get());
    EXPECT_EQ(10.0, valueOf<double>(copy));
    indexCopy->set(2);
    EXPECT_EQ(20.0, valueOf<double>(copy));
    EXPECT_EQ(10.0, valueOf<double>(x));
    grow(pathCopy->set());
    EXPECT_TRUE(copy->update(variable(5.0).get()));
    EXPECT_EQ(5.0, pathCopy->rvalue()[2].x);
    EXPECT_EQ(20.0, path->rvalue()[2].x);
}

TEST_F(ElementMembers, CopiesOfArraysWithinThemReferToTheCopies) {
    const auto tanks = local(Tanks(2));
    tanks->set()[1].weights[2] = 4;
    index->set(1);
    inner->set(2);
    const SourcePtr weight = element(element(tanks, index)->getMember("weights"), inner);
    std::map<const base::DataSourceBase*, base::DataSourceBase*> copies;
    const SourcePtr copy(weight->copy(copies));
    const auto tanksCopy = internal::ValueDataSource<Tanks>::narrow(copies[tanks.get()]);
    ASSERT_TRUE(tanksCopy);
    grow(tanksCopy->set());
    EXPECT_EQ(4.0, valueOf<double>(copy));
    EXPECT_TRUE(copy->update(variable(9.0).get()));
    EXPECT_EQ(9.0, tanksCopy->rvalue()[1].weights[2]);
    EXPECT_EQ(4.0, tanks->rvalue()[1].weights[2]);
}
