// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "Controller.hpp"

#include <rtt/internal/DataSources.hpp>

#include <iostream>

namespace tank {

Controller::Controller(const std::string& name) : ControllerBase(name) {}

Controller::~Controller() { this->stopForGood(); }

bool Controller::startHook() {
    received_ = 0;
    out_of_order_ = 0;
    sample_ = LevelSample();
    return true;
}

void Controller::updateHook() {
    if (getPeriod() > 0.0) {
        readOne();
    } else {
        while (readOne()) {
        }
    }
}

bool Controller::readOne() {
    const int previous = sample_.number;
    if (level_.read(sample_, false) != RTT::NewData) return false;
    ++received_;
    if (sample_.number <= previous) ++out_of_order_;
    if (sample_.number % show_every_ == 0) {
        // The type knows its own text, as the console would show it: new fields appear by themselves.
        RTT::base::DataSourceBase::shared_ptr value(new RTT::internal::ReferenceDataSource<LevelSample>(sample_));
        std::cout << getName() << " sees " << value << std::endl;
    }
    return true;
}

bool Controller::finish(int sent, int refused) {
    while (readOne()) {
    }
    const int lost = sent - received_;
    const bool good = lost == refused && out_of_order_ == 0;
    std::cout << "verdict: sent " << sent << ", received " << received_ << ", lost " << lost << ": "
              << (good ? "OK, every sample arrived in order or was refused by a full buffer" : "WRONG") << std::endl;
    return good;
}

}  // namespace tank
