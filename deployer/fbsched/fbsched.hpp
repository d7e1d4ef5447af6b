// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_FBSCHED_HPP
#define ORO_FBSCHED_HPP

#include <ocl/Chain.hpp>

#include <string>

/** The chain by its old name. Slaves of it that the property sched_order does not name follow in alphabetical order. */
class OCL_API FBSched : public OCL::Chain {
public:
    explicit FBSched(const std::string& name);
    ~FBSched() override;
};

#endif
