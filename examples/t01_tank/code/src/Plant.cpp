// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "Plant.hpp"

namespace tank {

Plant::Plant(const std::string& name) : PlantBase(name) {}

Plant::~Plant() { this->stopForGood(); }

bool Plant::startHook() {
    // Without a controller there is nobody to report to; the plant works all the same.
    if (TaskContext* controller = getPeer("controller"))
        finish_ = RTT::OperationCaller<bool(int, int)>(controller->getOperation("finish"), engine());
    sample_ = first_;
    refused_ = 0;
    level_.setDataSample(sample_);  // sizes the connection, so that writing allocates nothing
    return true;
}

void Plant::updateHook() {
    if (sample_.number == samples_) return;
    ++sample_.number;
    sample_.level += inflow_;
    if (level_.write(sample_) != RTT::WriteSuccess) ++refused_;
    if (sample_.number == samples_) finish_.send(samples_, refused_);
}

}  // namespace tank
