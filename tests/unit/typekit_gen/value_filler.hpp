// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Gives every field of a value, and every element of its containers, a value of its own.
#ifndef OROFORGE_TESTS_VALUE_FILLER_HPP
#define OROFORGE_TESTS_VALUE_FILLER_HPP

#include <string>
#include <vector>

#include <model/type_model.hpp>
#include <rtt/base/DataSourceBase.hpp>

namespace oroforge::test {

class ValueFiller {
public:
    /// `model` tells what elements of sets and maps are. Another `seed` gives other values.
    explicit ValueFiller(const model::TypeModel& model, unsigned seed = 0) : model_(model), next_(seed) {}

    void fill(const RTT::base::DataSourceBase::shared_ptr& value, const std::string& path = "");

    /// The way to each number and text that was filled: ".points[1].x".
    const std::vector<std::string>& paths() const { return paths_; }

private:
    void fillLeaf(const RTT::base::DataSourceBase::shared_ptr& value);
    void fillElements(const RTT::base::DataSourceBase::shared_ptr& value, const std::string& path);
    bool fillKeyed(const RTT::base::DataSourceBase::shared_ptr& value);

    const model::TypeModel& model_;
    unsigned next_;
    std::vector<std::string> paths_;
    unsigned depth_ = 0;
};

}  // namespace oroforge::test

#endif
